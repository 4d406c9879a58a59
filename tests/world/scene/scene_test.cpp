#include "world/scene/scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/world/scene_texts.h"

namespace prairie {
namespace {

using testing::expect_refused;
using testing::kPlainScene;
using testing::Refusal;
using testing::refusal_of;

std::string plain_with(const std::string& more) {
  return std::string(kPlainScene) + more;
}

TEST(Scene, HasDefaults) {
  const Scene scene = parse_scene(kPlainScene, "folder", {});
  EXPECT_EQ(scene.seed, 1u);
  EXPECT_EQ(scene.tile_m, 4.0);
  EXPECT_EQ(scene.extent_m, glm::dvec2(40.0, 20.0));
  EXPECT_FALSE(scene.height);
  ASSERT_EQ(scene.species.size(), 1u);
  EXPECT_EQ(scene.species[0].species.name, "fescue");
  EXPECT_EQ(scene.species[0].uniform_density_per_m2, 1000.0);
  EXPECT_FLOAT_EQ(scene.species[0].species.params.height_m, 0.32f);
  EXPECT_FLOAT_EQ(scene.species[0].species.params.width_m, 0.0035f);
  EXPECT_EQ(scene.lod.quality, Quality::kMedium);
  EXPECT_TRUE(scene.cameras.empty());
}

constexpr const char* kSurveyedScene = R"(
version = 1
seed = 77
tile_m = 8
[height]
file = "dtm.tif"
spacing_m = 2
range = [100, 200.5]
channel = "R"
nodata = -1
repeat = true
[ground]
soil_color = [0.1, 0.2, 0.3]
[[species]]
name = "fescue"
density = 500
height_m = 0.5
width_mm = 4
tilt_deg = 90e-1
root_color = "#000000"
tip_color = [0.5, 0.25, 1]
[[species]]
name = "tall oat"
density.file = "/maps/oat.png"
density.range = [255, 0]
density.curve = 2
density.max_per_m2 = 300
[maps]
blade_height = { file = "a.png", range = [0, 200], max = 1.5 }
bend = { file = "b.png", repeat = false }
color = { file = "c.png", spacing_m = 3 }
[[camera]]
name = "default"
position_m = [1, 2.5, "+1.7"]
yaw_deg = -10
pitch_deg = 5
fov_deg = 45
[[camera]]
name = "sky"
position_m = [0, 0, 300]
[sun]
azimuth_deg = 90
elevation_deg = 10
color = [2, 1, 1]
intensity = 5
[sky]
intensity = 0.5
haze_per_m = 0.01
[lod]
quality = "high"
blade_distance_m = 60
)";

TEST(Scene, ReadsItsGround) {
  const Scene scene = parse_scene(kSurveyedScene, "/scenes/a", {});
  EXPECT_EQ(scene.seed, 77u);
  EXPECT_EQ(scene.tile_m, 8.0);
  ASSERT_TRUE(scene.height);
  EXPECT_EQ(scene.height->file, "/scenes/a/dtm.tif");
  EXPECT_EQ(scene.height->field, "height.file");
  EXPECT_EQ(scene.height->spacing_m, 2.0);
  EXPECT_EQ(scene.height->range, (std::array{100.0, 200.5}));
  EXPECT_EQ(scene.height->channel, "R");
  EXPECT_EQ(scene.height->nodata, -1.0);
  EXPECT_TRUE(scene.height->repeats);
  EXPECT_EQ(scene.soil_color, glm::vec3(0.1f, 0.2f, 0.3f));
}

TEST(Scene, ReadsItsSpeciesAndMaps) {
  const Scene scene = parse_scene(kSurveyedScene, "/scenes/a", {});
  const SpeciesParams& fescue = scene.species.at(0).species.params;
  EXPECT_EQ(scene.species[0].uniform_density_per_m2, 500.0);
  EXPECT_EQ(fescue.height_m, 0.5f);
  EXPECT_EQ(fescue.width_m, 0.004f);
  EXPECT_FLOAT_EQ(fescue.tilt_rad, static_cast<float>(std::numbers::pi / 20.0));
  EXPECT_EQ(fescue.tip_color, glm::vec3(0.5f, 0.25f, 1.0f));
  const MapSpec& oat = scene.species.at(1).density.value();
  EXPECT_EQ(oat.file, "/maps/oat.png");
  EXPECT_EQ(oat.field, "species.1.density.file");
  EXPECT_EQ(oat.range, (std::array{255.0, 0.0}));
  EXPECT_EQ(oat.curve, 2.0);
  EXPECT_EQ(oat.max, 300.0);
  EXPECT_TRUE(oat.repeats) << "with the height map";
  EXPECT_EQ(scene.blade_height.value().max, 1.5);
  EXPECT_FALSE(scene.bend.value().repeats);
  EXPECT_EQ(scene.color.value().spacing_m, 3.0);
}

TEST(Scene, ReadsItsViews) {
  const Scene scene = parse_scene(kSurveyedScene, "/scenes/a", {});
  ASSERT_EQ(scene.cameras.size(), 2u);
  EXPECT_TRUE(scene.cameras[0].z_above_ground);
  EXPECT_EQ(scene.cameras[0].z_m, 1.7);
  EXPECT_EQ(scene.cameras[0].position_m, glm::dvec2(1.0, 2.5));
  EXPECT_EQ(scene.cameras[0].fov_deg, 45.0);
  EXPECT_FALSE(scene.cameras[1].z_above_ground);
  EXPECT_EQ(scene.cameras[1].z_m, 300.0);
  EXPECT_EQ(scene.sun.azimuth_deg, 90.0);
  EXPECT_EQ(scene.sun.haze_per_m, 0.01);
  EXPECT_EQ(scene.lod.quality, Quality::kHigh);
  EXPECT_EQ(scene.lod.blade_distance_m, 60.0);
}

class SceneRefusal : public ::testing::TestWithParam<Refusal> {};

TEST_P(SceneRefusal, NamesTheField) {
  expect_refused(GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Values, SceneRefusal,
    ::testing::Values(
        Refusal{"heigth_m = 0.3", "species.0.heigth_m",
                "line 6, expected a known one; did you mean 'height_m'?"},
        Refusal{"height = 0.3", "species.0.height", "did you mean 'height_m'?"},
        Refusal{"colour = 1", "species.0.colour", "one of name, density, height_m"},
        Refusal{"height_m = -1", "species.0.height_m", "found -1 in line 6, expected a number from"},
        Refusal{"height_m = nan", "species.0.height_m", "found nan"},
        Refusal{"height_m = inf", "species.0.height_m", "found inf"},
        Refusal{"height_m = \"tall\"", "species.0.height_m", "found the text \"tall\""},
        Refusal{"height_m = true", "species.0.height_m", "found true"},
        Refusal{"height_m = [1]", "species.0.height_m", "found a list of 1"},
        Refusal{"height_m = 2020-01-01", "species.0.height_m", "found a date or time"},
        Refusal{"density = -1", "species.0.density", "found -1"},
        Refusal{"density = 100001", "species.0.density", "from 0 to 100000"},
        Refusal{"density = \"many\"", "species.0.density", "blades per m²"},
        Refusal{"density = {}", "species.0.density.file", "the path of an image"},
        Refusal{"density = { fiel = \"a\" }", "species.0.density.fiel", "did you mean 'file'?"},
        Refusal{"density = { file = 3 }", "species.0.density.file", "the path of an image or raster"},
        Refusal{"density = { file = \"\" }", "species.0.density.file", "the path of an image"},
        Refusal{"density = { file = \"a\", max_per_m2 = 2e5 }", "species.0.density.max_per_m2", "100000"},
        Refusal{"density = { file = \"a\", max_per_m2 = -1 }", "species.0.density.max_per_m2", "found -1"},
        Refusal{"density = { file = \"a\", range = [1, 1] }", "species.0.density.range",
                "two different numbers"},
        Refusal{"density = { file = \"a\", range = [1] }", "species.0.density.range",
                "a list of two numbers"},
        Refusal{"density = { file = \"a\", range = [1, \"2\"] }", "species.0.density.range",
                "found the text"},
        Refusal{"density = { file = \"a\", curve = 0 }", "species.0.density.curve", "found 0"},
        Refusal{"density = { file = \"a\", spacing_m = 0 }", "species.0.density.spacing_m", "found 0"},
        Refusal{"density = { file = \"a\", channel = \"\" }", "species.0.density.channel",
                "a channel's name"},
        Refusal{"tip_color = \"green\"", "species.0.tip_color", "\"#rrggbb\""},
        Refusal{"tip_color = [0, 0]", "species.0.tip_color", "[r, g, b]"},
        Refusal{"tip_color = [0, 0, 2]", "species.0.tip_color", "from 0 to 1"},
        Refusal{"[[species]]", "species.1.name", "a name"},
        Refusal{"[[species]]\nnam = \"a\"", "species.1.nam", "did you mean 'name'?"},
        Refusal{"[[species]]\nname = \"fescue\"", "species.1.name", "a name not yet given"},
        Refusal{"[[species]]\nname = \"a.b\"", "species.1.name", "letters"},
        Refusal{"[[species]]\nname = \"1a\"", "species.1.name", "a letter first"},
        Refusal{"[lod]\nquality = \"hihg\"", "lod.quality", "did you mean 'high'?"},
        Refusal{"[lod]\nquality = 2", "lod.quality", "a text in quotes"},
        Refusal{"[lodd]", "lodd", "did you mean 'lod'?"},
        Refusal{"[sun]\nelevation_deg = 95", "sun.elevation_deg", "from 0 to 90"},
        Refusal{"[sky]\nhaze_per_m = -1", "sky.haze_per_m", "found -1"},
        Refusal{"[height]", "height.file", "the path of an image"},
        Refusal{"[height]\nfile = \"a.tif\"", "ground.size_m", "a size beside a height map"},
        Refusal{"[maps]\nbending = {}", "maps.bending", "one of blade_height, bend, color"},
        Refusal{"[maps]\ncolor = { file = \"a\", max = 2 }", "maps.color.max", "unknown key"},
        Refusal{"[[camera]]\nname = \"a\"", "camera.0.position_m", "[x, y, z]"},
        Refusal{"[[camera]]\nname = \"a\"\nposition_m = [0, 0, \"1.7\"]", "camera.0.position_m", "\"+1.7\""},
        Refusal{"[[camera]]\nname = \"a\"\nposition_m = [0, 0, \"+\"]", "camera.0.position_m", "\"+1.7\""},
        Refusal{"[[camera]]\nname = \"a\"\nposition_m = [0, 0, \"+nan\"]", "camera.0.position_m", "\"+1.7\""},
        Refusal{"[[camera]]\nname = \"a\"\nposition_m = [0, 0, \"+1 m\"]", "camera.0.position_m", "\"+1.7\""},
        Refusal{"[[camera]]\nname = \"a,b\"\nposition_m = [0, 0, 1]", "camera.0.name", "a name"},
        Refusal{"[camera]\nname = \"a\"", "camera", "[[camera]]"},
        Refusal{"camera = [1]", "species.0.camera", "unknown"}));

TEST(Scene, NamesLineAndColumnOfASyntaxError) {
  const Fault fault = refusal_of("version = 1\nseed = = 3\n");
  EXPECT_EQ(fault.field, "line 2, column 8");
}

TEST(Scene, RefusesANewerVersion) {
  const Fault fault = refusal_of("version = 2\nnew_key = 1\n");
  EXPECT_EQ(fault.field, "version");
  EXPECT_NE(fault.found.find("version 2, newer than this program"), std::string::npos);
}

TEST(Scene, WantsAVersion) {
  EXPECT_EQ(refusal_of("seed = 1").field, "version");
  EXPECT_EQ(refusal_of("").field, "version");
  EXPECT_EQ(refusal_of("version = 0").field, "version");
  EXPECT_EQ(refusal_of("version = 1.0").field, "version");
}

TEST(Scene, WantsASpecies) {
  EXPECT_EQ(refusal_of("version = 1\n[ground]\nsize_m = [1, 1]").field, "species");
  EXPECT_EQ(refusal_of("version = 1\nspecies = []\n[ground]\nsize_m = [1, 1]").field, "species");
}

TEST(Scene, TakesSixteenSpeciesAndNoMore) {
  std::string text = "version = 1\n[ground]\nsize_m = [8, 8]\n";
  for (int k = 0; k < kMaxSpecies; ++k) text += fmt::format("[[species]]\nname = \"s{}\"\n", k);
  EXPECT_EQ(parse_scene(text, "folder", {}).species.size(), 16u);
  EXPECT_EQ(refusal_of(text + "[[species]]\nname = \"one more\"\n").field, "species");
}

TEST(Scene, WantsAnExtent) {
  EXPECT_EQ(refusal_of("version = 1\n[[species]]\nname = \"a\"").field, "ground.size_m");
  EXPECT_NO_THROW(
      parse_scene("version = 1\n[[species]]\nname = \"a\"\ndensity = { file = \"a.png\" }", "f", {}));
}

TEST(Scene, KeepsHostileTextOnOneShortLine) {
  const std::string text =
      refusal_of(plain_with("\"a\\nb\\u001b" + std::string(5000, 'x') + "\" = 1")).what();
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_LT(text.size(), 1000u);
}

TEST(Scene, RefusesDeepNestingAndBinary) {
  EXPECT_FALSE(refusal_of("a = " + std::string(100'000, '[')).field.empty());
  EXPECT_FALSE(refusal_of(std::string("\0\1\2\xff\xfe", 5)).field.empty());
}

TEST(Scene, NamesAMissingFile) {
  const TemporaryFolder folder;
  try {
    read_scene(folder / "nowhere", {});
    FAIL();
  } catch (const BadInput& fault) {
    EXPECT_EQ(fault.file, (folder / "nowhere/scene.toml").string());
    EXPECT_EQ(fault.found, "no such file");
  }
}

TEST(Scene, RefusesAFolderInPlaceOfAFileAndAHugeFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "scene.toml");
  EXPECT_THROW(read_scene(folder.path(), {}), BadInput);
  std::filesystem::create_directories(folder / "huge");
  testing::write_text(folder / "huge/scene.toml", "version = 1\n");
  std::filesystem::resize_file(folder / "huge/scene.toml", std::uintmax_t{1} << 40);
  EXPECT_THROW(read_scene(folder / "huge", {}), BadInput);
}

}  // namespace
}  // namespace prairie
