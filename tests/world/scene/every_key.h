// Scenes that set every key there is; but for the maps that repeat, none to its default.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace prairie::testing {

/// Every key but those that exclude others of it.
inline constexpr const char* kEveryKeyScene = R"(version = 1
seed = 77
tile_m = 8
[height]
file = "dtm.tif"
spacing_m = 2
nodata = -1
repeat = true
channel = "R"
range = [100, 200.5]
[ground]
soil_color = "#5d5040"
[[species]]
name = "tussock"
density = 512.5
height_m = 0.45
height_spread = 0.3
width_mm = 4.1
width_spread = 0.2
tilt_deg = 17
lean_deg = 11.5
curvature_deg = 52
curvature_spread = 0.4
mass_g = 0.07
stiffness = 55
stiffness_spread = 0.25
clump_m = 0.6
clump_strength = 0.9
clump_spray_deg = 35
dry_share = 0.2
dry_spread = 0.1
hue_spread = 0.4
specular = 0.05
root_color = [0.05, 0.07, 0.02]
tip_color = "#b59a55"
dry_color = [0.4, 0.3, 0.1]
transmission = [0.6, 0.8, 0.2]
damping_ratio = 0.4
drag_coefficient = 1.1
[[species]]
name = "tall oat"
[species.density]
file = "/maps/oat.png"
spacing_m = 0.5
nodata = 0
repeat = false
channel = "G"
range = [255, 0]
curve = 2
max_per_m2 = 300
[maps.blade_height]
file = "a.png"
spacing_m = 1
nodata = 3
repeat = false
channel = "B"
range = [0, 200]
max = 1.5
[maps.bend]
file = "b.png"
spacing_m = 1.5
nodata = 4
repeat = true
channel = "A"
range = [1, 2]
max = 1.25
[maps.color]
file = "c.png"
spacing_m = 3
nodata = 5
repeat = true
[[camera]]
name = "default"
position_m = [1, 2.5, "+1.7"]
yaw_deg = -10
pitch_deg = 5
fov_deg = 45
[[camera]]
name = "sky"
position_m = [0, 0, 300]
[[camera]]
name = "mole"
position_m = [5, 6, "-0.25"]
[sun]
azimuth_deg = 90
elevation_deg = 10
color = [2, 1, 0.5]
intensity = 5
[sky]
intensity = 0.5
haze_per_m = 0.01
[lod]
quality = "high"
blade_distance_m = 60
[wind]
speed_m_per_s = 6.5
heading_deg = 180
turbulence = 0.5
[[wind.gust]]
position_m = [1, 2]
heading_deg = 10
travel_m_per_s = 9
strength_m_per_s = -7
width_m = 50
depth_m = 20
way_m = 200
start_s = 3
[[wind.tornado]]
position_m = [3, 4]
heading_deg = 75
travel_m_per_s = 1
strength_m_per_s = 20
radius_m = 2
reach_m = 30
inflow = 0.5
wander_m = 6
wander_s = 7
start_s = 8
duration_s = 9
seed = 4294967295
[[wind.breeze]]
position_m = [5, 6]
heading_deg = -91
strength_m_per_s = 2
period_s = 3
wavelength_m = 10
radius_m = 40
[[wind.gust]]
[[condition]]
centre_m = [5, 5.5]
velocity_m_per_s = [0.1, -2]
radius_m = 4
edge_m = 1.5
start_s = 2
duration_s = 30
fade_s = 5
stiffness_factor = 3
color_factor = [1.4, 1.5, 1.8]
[[condition]]
radius_m = 2
[treading]
recovery_s = 120
most_tilt_deg = 45
spacing_m = 0.2
field_scale = 0.7
load_slowing = 4
worn_slowing = 5
wear_passes = 10
worn_field = 0.3
[[mover]]
name = "cart"
kind = "cart"
radius_m = 0.9
speed_m_per_s = 2
start_s = -4
loops = true
path_m = [[0, 0], [5.5, 5], [8, -1]]
[[mover]]
name = "boulder"
path_m = [[0, 0], [5, 5]]
[[obstacle]]
kind = "trunk"
position_m = [10, 11]
radius_m = 0.3
height_m = 4
[[obstacle]]
kind = "box"
position_m = [12, 13]
size_m = [1, 2, 3]
heading_deg = 33
[[obstacle]]
kind = "rock"
position_m = [14, 15]
size_m = [1.5, 2.5, 0.5]
heading_deg = -200
seed = 9
[[wall]]
outline_m = [[0, 0], [40, 0], [40, 40], [0, 40]]
holes_m = [[[10, 30], [12, 30], [11, 32]]]
walkers = "outside"
height_m = 2
[[goal]]
name = "well"
position_m = [91, 70]
radius_m = 2
stay_s = 3
[[goal]]
name = "gate"
position_m = [60, 70.5]
[[walkers]]
name = "carriers"
count = 10
behaviour = "visit"
goals = ["gate", "well"]
position_m = [112, 48]
radius_m = 9
speed_m_per_s = 1.5
speed_spread = 0.1
height_m = 1.8
height_spread = 0.05
body_radius_m = 0.3
sensor_m = 5
noise = 0.2
)";

/// The keys that exclude others: level ground, a measured wind, walkers with a place for each.
inline constexpr const char* kExcludingKeysScene = R"(version = 1
[ground]
size_m = [40.5, 20]
[[species]]
name = "a"
[wind]
file = "w.csv"
place_m = [1, 2]
[[walkers]]
name = "pair"
starts_m = [[3, 4], [5, 6.5]]
)";

/// The keys of maps that say what other people's rasters leave out, and a mosaic.
inline constexpr const char* kForeignMapsScene = R"(version = 1
density_per = "surface"
[height]
file = ["dtm.raw", "more/dtm.raw"]
crs = "EPSG:32614"
size_px = [64, 65]
scale = 0.25
[[species]]
name = "a"
[species.density]
file = "a.asc"
crs = "EPSG:25833"
size_px = [10, 11]
[maps.blade_height]
file = "a.png"
crs = "EPSG:25832"
size_px = [2, 2]
[maps.bend]
file = "b.png"
crs = "EPSG:25832"
size_px = [3, 2]
[maps.color]
file = "c.png"
crs = "EPSG:25832"
size_px = [2, 3]
)";

/// Hashes of the files that they name, by their fields.
inline const std::map<std::string, std::uint64_t> kEveryFile{
    {"height.file", 1},           {"species.1.density.file", 2}, {"maps.blade_height.file", 3},
    {"maps.bend.file", 4},        {"maps.color.file", 5},        {"wind.file", 6},
    {"species.0.density.file", 7}};

}  // namespace prairie::testing
