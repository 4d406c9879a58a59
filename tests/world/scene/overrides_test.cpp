#include "world/scene/overrides.h"

#include <gtest/gtest.h>

#include "tests/world/scene_texts.h"

namespace prairie {
namespace {

using testing::kPlainScene;

Scene with(const std::vector<std::string>& overrides) {
  return parse_scene(kPlainScene, "folder", overrides);
}

Fault refusal(const std::string& assignment) {
  try {
    with({assignment});
  } catch (const BadOverride& fault) {
    return fault;
  }
  return Fault("", "", "no refusal", "one");
}

TEST(Overrides, SetPlainText) {
  EXPECT_EQ(with({"lod.quality=high"}).lod.quality, Quality::kHigh);
}
TEST(Overrides, SetQuotedText) {
  EXPECT_EQ(with({"lod.quality=\"low\""}).lod.quality, Quality::kLow);
}
TEST(Overrides, SetNumbers) {
  EXPECT_EQ(with({" sun.elevation_deg = 20 "}).sun.elevation_deg, 20.0);
}
TEST(Overrides, SetColors) {
  EXPECT_EQ(with({"sun.color=#ff0000"}).sun.color, glm::vec3(1.0f, 0.0f, 0.0f));
}
TEST(Overrides, SetLists) {
  EXPECT_EQ(with({"ground.size_m=[3, 4]"}).extent_m, glm::dvec2(3.0, 4.0));
}
TEST(Overrides, ReachSpeciesByIndex) {
  EXPECT_EQ(with({"species.0.height_m=0.5"}).species[0].species.params.height_m, 0.5f);
}
TEST(Overrides, ReachSpeciesByName) {
  EXPECT_EQ(with({"species.fescue.height_m=0.5"}).species[0].species.params.height_m, 0.5f);
}
TEST(Overrides, ReplaceANumberByAMap) {
  const Scene scene = with({"species.0.density={ file = \"a.png\" }", "species.0.density.max_per_m2=7"});
  EXPECT_EQ(scene.species[0].density.value().max, 7.0);
}
TEST(Overrides, TheLastOneHolds) {
  EXPECT_EQ(with({"seed=3", "seed=4"}).seed, 4u);
}

TEST(Overrides, ARefusalNamesTheKeyAsTyped) {
  const Fault fault = refusal("species.fescue.heigth_m=1");
  EXPECT_EQ(fault.file, "");
  EXPECT_EQ(fault.field, "--set species.fescue.heigth_m");
  EXPECT_NE(fault.expected.find("did you mean 'height_m'?"), std::string::npos);
  EXPECT_EQ(fault.found.find("line"), std::string::npos) << "the command line has no lines";
}

TEST(Overrides, AreRefused) {
  for (const char* assignment : {"seed",
                                 "seed=",
                                 "=3",
                                 ".seed=3",
                                 "lod.=high",
                                 "lod..quality=high",
                                 "lodd.quality=high",
                                 "lod.quality=best",
                                 "species=3",
                                 "species.0=3",
                                 "species.1.height_m=1",
                                 "species.oat.height_m=1",
                                 "species..height_m=1",
                                 "seed.x=1",
                                 "seed=1.5",
                                 "seed=nan",
                                 "seed=1\nlod.quality=\"high\"",
                                 "ground.size_m.0=3",
                                 "camera.0.yaw_deg=1",
                                 "species.0.density=-1",
                                 "species.0.name=",
                                 "version=2",
                                 "ground.size_m=[0,0]"}) {
    const Fault fault = refusal(assignment);
    EXPECT_EQ(fault.field.rfind("--set", 0), 0u) << assignment << ": " << fault.what();
    EXPECT_EQ(std::string(fault.what()).find('\n'), std::string::npos) << assignment;
  }
}

TEST(Overrides, DoNotHideAFaultOfTheFile) {
  try {
    parse_scene("version = 1\nseed = -1\n", "folder", {"seed=1"});
    FAIL();
  } catch (const BadOverride&) {
    FAIL() << "the file's own fault";
  } catch (const BadInput& fault) {
    EXPECT_EQ(fault.field, "seed");
  }
}

}  // namespace
}  // namespace prairie
