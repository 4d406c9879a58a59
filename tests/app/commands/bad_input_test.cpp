// Broken scenes and maps: one line that names the file, the field and what was expected; exit code 3;
// quickly, within little memory, and without touching what stood where the output would have gone.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <ostream>

#include "tests/app/commands/program.h"
#include "tests/app/small_scene.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;
using testing::Outcome;

constexpr double kLongestS = 5.0;
constexpr long kMostMemoryMib = 512;

/// Exchanges a piece of the small scene's text.
void change_toml(const fs::path& scene, const std::string& from, const std::string& to) {
  std::string text = testing::small_scene_toml();
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  testing::write_text(scene / "scene.toml", text.replace(at, from.size(), to));
}

void write_heights(const fs::path& scene, float value) {
  const std::vector<float> heights(17 * 17, value);
  testing::write_image(scene / "ground.tif", 17, 17, 1, OIIO::TypeDesc::FLOAT, heights);
}

struct Breakage {
  std::string name;
  std::function<void(const fs::path& scene)> apply;
  std::vector<std::string> mentions;  // file, field, and perhaps more
};

void PrintTo(const Breakage& breakage, std::ostream* out) {
  *out << breakage.name;
}

std::function<void(const fs::path&)> toml(const std::string& from, const std::string& to) {
  return [=](const fs::path& scene) { change_toml(scene, from, to); };
}

/// Adds to the small scene's text.
std::function<void(const fs::path&)> more(const std::string& sections) {
  return [=](const fs::path& scene) {
    testing::write_text(scene / "scene.toml", testing::small_scene_toml() + sections);
  };
}

/// A wind that is replayed from these rows.
std::function<void(const fs::path&)> measured(const std::string& rows) {
  return [=](const fs::path& scene) {
    testing::write_text(scene / "wind.csv", "time_s,speed_m_per_s,heading_rad\n" + rows);
    more("[wind]\nfile = \"wind.csv\"\n")(scene);
  };
}

const std::string kMax = "max_per_m2 = 100 ";
const std::string kDensityMap = "density = { file = \"density.png\", spacing_m = 1.0, max_per_m2 = 100 }";

const std::vector<Breakage> kBreakages{
    {"NoFolder", [](const fs::path& scene) { fs::remove_all(scene); }, {"scene.toml"}},
    {"NoSceneFile", [](const fs::path& scene) { fs::remove(scene / "scene.toml"); }, {"scene.toml"}},
    {"SceneFileIsAFolder",
     [](const fs::path& scene) {
       fs::remove(scene / "scene.toml");
       fs::create_directory(scene / "scene.toml");
     },
     {"scene.toml"}},
    {"MissingMap", [](const fs::path& scene) { fs::remove(scene / "ground.tif"); }, {"ground.tif", "height"}},
    {"TruncatedPng",
     [](const fs::path& scene) {
       std::vector<std::uint8_t> noise(200 * 200);
       for (std::size_t k = 0; k < noise.size(); ++k)
         noise[k] = static_cast<std::uint8_t>(k * k * 2654435761u >> 11);
       testing::write_image(scene / "density.png", 200, 200, 1, OIIO::TypeDesc::UINT8, noise);
       fs::resize_file(scene / "density.png", fs::file_size(scene / "density.png") / 2);
     },
     {"density.png", "density"}},
    {"TruncatedTiff",
     [](const fs::path& scene) {
       fs::resize_file(scene / "ground.tif", fs::file_size(scene / "ground.tif") / 2);
     },
     {"ground.tif", "height"}},
    {"DecompressionBomb",
     [](const fs::path& scene) {
       testing::write_bytes(scene / "density.png", testing::png_bomb(40000, 40000, false));
     },
     {"density.png", "density"}},
    {"ZeroSizeMap",
     [](const fs::path& scene) {
       testing::write_bytes(scene / "density.png", testing::png_bomb(0, 0, false));
     },
     {"density.png", "density"}},
    {"EmptyFile",
     [](const fs::path& scene) { testing::write_text(scene / "density.png", ""); },
     {"density.png", "density"}},
    {"OnlyNodata", [](const fs::path& scene) { write_heights(scene, -9999.0f); }, {"ground.tif", "height"}},
    {"OnlyNan",
     [](const fs::path& scene) { write_heights(scene, std::numeric_limits<float>::quiet_NaN()); },
     {"ground.tif", "height"}},
    {"NanInScene", toml("tile_m = 4.0", "tile_m = nan"), {"scene.toml", "tile_m"}},
    {"NegativeDensity", toml(kDensityMap, "density = -5.0"), {"scene.toml", "density", "-5"}},
    {"TooLargeDensity", toml(kDensityMap, "density = 100001.0"), {"scene.toml", "density", "100001"}},
    {"NegativeDensityOfMap", toml(kMax, "max_per_m2 = -1 "), {"scene.toml", "max_per_m2"}},
    {"TooLargeDensityOfMap", toml(kMax, "max_per_m2 = 200000 "), {"scene.toml", "max_per_m2"}},
    {"Typo", toml("tile_m", "tlie_m"), {"scene.toml", "tlie_m", "tile_m"}},
    {"UnknownKey", toml("seed = 5", "seed = 5\ncolour_of_sheep = 1"), {"scene.toml", "colour_of_sheep"}},
    {"UnknownTable", toml("[height]", "[goats]\nnumber = 3\n[height]"), {"scene.toml", "goats"}},
    {"WrongType", toml("tile_m = 4.0", "tile_m = \"four\""), {"scene.toml", "tile_m", "four"}},
    {"NewerVersion", toml("version = 1", "version = 2"), {"scene.toml", "version"}},
    {"NanWind", more("[wind]\nspeed_m_per_s = nan\n"), {"scene.toml", "wind.speed_m_per_s", "nan"}},
    {"UnknownPrimitive", more("[[wind.whirl]]\n"), {"scene.toml", "wind.whirl", "gust, tornado, breeze"}},
    {"MistypedPrimitive", more("[[wind.tornadoe]]\n"), {"scene.toml", "'tornado'"}},
    {"NegativeRadiusOfATornado",
     more("[[wind.tornado]]\nradius_m = -2\n"),
     {"scene.toml", "wind.tornado.0.radius_m", "-2"}},
    {"TornadoWithoutReach",
     more("[[wind.tornado]]\nradius_m = 5\nreach_m = 4\n"),
     {"scene.toml", "wind.tornado.0.reach_m", "5 to"}},
    {"NegativeRadiusOfFrost",
     more("[[condition]]\nradius_m = -2\n"),
     {"scene.toml", "condition.0.radius_m", "-2"}},
    {"FrostThatIsMoreThanEdge",
     more("[[condition]]\nradius_m = 5\nedge_m = 6\n"),
     {"scene.toml", "condition.0.edge_m", "0.01 to 5"}},
    {"MistypedCondition", more("[[condition]]\nstiffnes_factor = 2\n"), {"scene.toml", "'stiffness_factor'"}},
    {"NanTreading", more("[treading]\nrecovery_s = nan\n"), {"scene.toml", "treading.recovery_s", "nan"}},
    {"MoverWithoutAPath",
     more("[[mover]]\nname = \"stone\"\npath_m = [[1, 1]]\n"),
     {"scene.toml", "mover.0.path_m", "2 to 1000 points"}},
    {"MoverThatStaysWhereItIs",
     more("[[mover]]\nname = \"stone\"\npath_m = [[1, 1], [1, 1]]\n"),
     {"scene.toml", "mover.0.path_m"}},
    {"MissingWindFile", more("[wind]\nfile = \"none.csv\"\n"), {"none.csv", "wind.file"}},
    {"WindFileIsAnImage", more("[wind]\nfile = \"density.png\"\n"), {"density.png", "time_s"}},
    {"WindFileWithAGap", measured("0,5,0\n1,,0\n2,5,0\n"), {"wind.csv", "line 3", "speed_m_per_s"}},
    {"WindFileWithAnEmptyLine", measured("0,5,0\n\n2,5,0\n"), {"wind.csv", "line 3"}},
    {"WindFileWithText", measured("0,5,0\n1,calm,0\n"), {"wind.csv", "line 3", "calm"}},
    {"WindFileWithTimeBackwards", measured("1,5,0\n0,5,0\n"), {"wind.csv", "line 3", "time_s"}},
    {"NoToml", toml("version = 1", "version = ]"), {"scene.toml"}},
};

class BadInput : public ::testing::TestWithParam<Breakage> {};

TEST_P(BadInput, IsRefusedInOneLine) {
  const TemporaryFolder folder;
  const fs::path scene = folder / "scene";
  testing::write_small_scene(scene);
  GetParam().apply(scene);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"render", "out.png"}, {"plant", "out.csv"}}) {
    const fs::path output = folder / command[1];
    testing::write_text(output, "what stood here before");
    const Outcome outcome = testing::prairie({command[0], scene.string(), "-o", output.string()});
    SCOPED_TRACE(outcome.err);
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
    EXPECT_TRUE(outcome.err.starts_with("prairie: "));
    EXPECT_NE(outcome.err.find("expected "), std::string::npos);
    for (const std::string& mention : GetParam().mentions) {
      EXPECT_NE(outcome.err.find(mention), std::string::npos) << mention;
    }
    EXPECT_LT(outcome.seconds, kLongestS);
    EXPECT_LT(outcome.largest_memory_mib, kMostMemoryMib);
    const std::vector<std::byte> kept = testing::read_bytes(output);
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(kept.data()), kept.size()), "what stood here before");
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, BadInput, ::testing::ValuesIn(kBreakages),
                         [](const auto& breakage) { return breakage.param.name; });

TEST(BadInputOfNew, RasterThatIsNone) {
  const TemporaryFolder folder;
  testing::write_text(folder / "notes.txt", "no raster");
  const Outcome outcome =
      testing::prairie({"new", (folder / "scene").string(), "--height", (folder / "notes.txt").string()});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_NE(outcome.err.find("notes.txt"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "scene" / "scene.toml"));
}

TEST(BadInputOfNew, RefusesAFolderThatIsNotEmpty) {
  const TemporaryFolder folder;
  testing::write_text(folder / "mine.txt", "precious");
  EXPECT_EQ(testing::prairie({"new", folder.path().string()}).exit_code, 2);
  EXPECT_FALSE(fs::exists(folder / "scene.toml"));
  EXPECT_EQ(testing::prairie({"new", folder.path().string(), "--force"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "mine.txt"));
}

}  // namespace
}  // namespace prairie
