#include "world/scene/scene_text.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/world/scene/every_key.h"
#include "tests/world/scene_texts.h"
#include "world/scene/key_unit.h"
#include "world/scene/scene_hash.h"

namespace prairie {
namespace {

Scene parsed(const std::string& text) {
  return parse_scene(text, "folder", {});
}

void expect_reads_back(const Scene& scene) {
  const std::string text = scene_text(scene);
  const Scene again = parse_scene(text, scene.folder, {});
  EXPECT_EQ(scene_hash(again, testing::kEveryFile), scene_hash(scene, testing::kEveryFile)) << text;
  EXPECT_EQ(scene_text(again), text);
}

TEST(SceneText, ReadsBackAsTheSameScene) {
  for (const char* text : {testing::kPlainScene, testing::kEveryKeyScene, testing::kExcludingKeysScene,
                           testing::kForeignMapsScene})
    expect_reads_back(parsed(text));
}

TEST(SceneText, OfExamplesReadsBackAsTheSameScene) {
  for (const char* name : {"meadow", "windy", "walkers", "frost"})
    expect_reads_back(read_scene(std::filesystem::path(PRAIRIE_EXAMPLES) / name, {}));
}

TEST(SceneText, SaysWhatIsNotAsItWouldBeWithoutAWord) {
  EXPECT_EQ(scene_text(parsed(testing::kPlainScene)),
            "version = 1\n\n[ground]\nsize_m = [40.0, 20.0]\n\n[[species]]\nname = \"fescue\"\n");
}

TEST(SceneText, KeepsPathsRelativeToTheScene) {
  const Scene scene = parse_scene(testing::kEveryKeyScene, "/scenes/a", {});
  const std::string text = scene_text(scene);
  EXPECT_NE(text.find("file = \"dtm.tif\"\n"), std::string::npos) << text;
  const Scene moved = parse_scene(text, "/elsewhere", {});
  EXPECT_EQ(moved.height->file, "/elsewhere/dtm.tif");
}

TEST(SceneText, KeepsAFileOfWindWithTurbulence) {
  expect_reads_back(
      parse_scene(testing::kExcludingKeysScene, "folder", {"wind.turbulence=1", "wind.place_m=[0, 0]"}));
}

TEST(SceneText, HasNotesWithTheFirstOfSeveral) {
  SceneNotes notes;
  notes.head = "# head\n";
  notes.sections = {{"species", "# above the section\n"}};
  notes.above = {{"species.height_m", "# above the key\n"}};
  notes.keys = {{"species.height_m", "behind it"}, {"species.tilt_deg", ""}};
  notes.below = {{"species", "# below\n"}};
  const Scene scene = parsed(std::string(testing::kPlainScene) + "[[species]]\nname = \"oat\"\n");
  EXPECT_EQ(scene_text(scene, notes),
            "# head\nversion = 1\n\n[ground]\nsize_m = [40.0, 20.0]\n\n"
            "# above the section\n[[species]]\nname = \"fescue\"\n"
            "# above the key\nheight_m = 0.32         # behind it\ntilt_deg = 12.0\n# below\n\n"
            "[[species]]\nname = \"oat\"\n");
}

TEST(KeyUnit, GivesBackTheNumberThatWasWritten) {
  std::mt19937 random(1);
  for (const Unit unit : {Unit::kMembers, Unit::kMillimetres, Unit::kDegrees, Unit::kBearing}) {
    for (int n = 0; n < 20'000; ++n) {
      const double key = (static_cast<int>(random() % 7'200'001) - 3'600'000) / 1e4;
      EXPECT_EQ(key_from_member(unit, member_from_key(unit, key), false), key);
      const auto member = static_cast<float>(member_from_key(unit, key));
      const double written = key_from_member(unit, static_cast<double>(member), true);
      EXPECT_EQ(static_cast<float>(member_from_key(unit, written)), member);
    }
  }
}

}  // namespace
}  // namespace prairie
