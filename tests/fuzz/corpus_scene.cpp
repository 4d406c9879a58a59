#include <string_view>

#include "tests/fuzz/corpus.h"

namespace prairie::fuzz {
namespace {

using std::string_view_literals::operator""sv;

constexpr std::string_view kPlain = "version = 1\n[ground]\nsize_m = [40, 20]\n[[species]]\nname = \"a\"\n"sv;

// What follows the NUL are overrides.
constexpr std::string_view kOverridden =
    "version = 1\n[ground]\nsize_m = [4, 4]\n[[species]]\nname = \"a\"\n\0"
    "lod.quality=high\nspecies.a.height_m=1\nspecies.0.density={ file = \"a\" }\nsun.color=#ffffff\n"sv;

constexpr std::string_view kEveryTable = R"(version = 1
seed = 77
tile_m = 8
[height]
file = "dtm.tif"
range = [100, 200.5]
channel = "R"
nodata = -1
repeat = true
[ground]
soil_color = [0.1, 0.2, 0.3]
[[species]]
name = "oat"
density = { file = "oat.png", range = [255, 0], curve = 2, max_per_m2 = 300, spacing_m = 0.5 }
height_m = 0.7
tip_color = "#b59a55"
[maps]
blade_height = { file = "a.png", max = 1.5 }
color = { file = "c.png" }
[[camera]]
name = "default"
position_m = [1, 2.5, "+1.7"]
pitch_deg = 5
[sun]
elevation_deg = 10
[sky]
haze_per_m = 0.01
[lod]
quality = "high"
)"sv;

constexpr std::string_view kMoving = R"(version = 1
[ground]
size_m = [40, 20]
[[species]]
name = "oat"
damping_ratio = 0.3
drag_coefficient = 0.5
[wind]
speed_m_per_s = 6
heading_deg = 45
turbulence = 1.5
[[wind.gust]]
position_m = [-20, 5]
heading_deg = 90
strength_m_per_s = 9
[[wind.tornado]]
position_m = [5, 5]
radius_m = 2
reach_m = 12.5
seed = 7
[[wind.breeze]]
period_s = 3
radius_m = 20
[[condition]]
centre_m = [5, 5]
velocity_m_per_s = [0.1, 0]
radius_m = 4
edge_m = 1.5
start_s = 2
duration_s = 30
fade_s = 5
color_factor = [1.4, 1.4, 1.8]
stiffness_factor = 3
[treading]
spacing_m = 0.1
recovery_s = 90
most_tilt_deg = 80
wear_passes = 20
[[mover]]
name = "boulder"
path_m = [[1, 1], [20, 3.5], [30, 18]]
loops = true
[[mover]]
name = "cart"
kind = "cart"
speed_m_per_s = 2
path_m = [[0, 0], [0, 9]]
)"sv;

constexpr std::string_view kReplayed =
    "version = 1\n[ground]\nsize_m = [4, 4]\n[[species]]\nname = \"a\"\n[wind]\nfile = \"w.csv\"\nplace_m = "
    "[1, "
    "2]\n\0wind.turbulence=1\ntreading.recovery_s=9\nwind.breeze=[{ period_s = 2 }]\n"sv;

}  // namespace

int replay_count() {
  return 40000;
}

std::vector<Input> make_corpus() {
  std::vector<Input> corpus;
  for (const std::string_view text : {kPlain, kOverridden, kEveryTable, kMoving, kReplayed})
    corpus.emplace_back(text.begin(), text.end());
  return corpus;
}

}  // namespace prairie::fuzz
