#include "world/scene_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "world/condition_keys.h"
#include "world/crowd_keys.h"
#include "world/motion_keys.h"
#include "world/scene_names.h"
#include "world/species_keys.h"
#include "world/wind_keys.h"

namespace prairie {
namespace {

constexpr std::int64_t kVersion = 1;
// A cell of the largest tile holds fewer blades at the largest density than an identity can count.
constexpr Bounds kTileM{0.5, 16.0};
constexpr Bounds kSizeM{0.5, 20'000.0};
constexpr Bounds kSpacingM{1e-3, 1e4};
constexpr Bounds kMapValue{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};
constexpr Bounds kPositionM{-1e6, 1e6};
constexpr Bounds kAlbedo{0.0, 1.0};
constexpr Bounds kLight{0.0, 100.0};

// Keys that every map has; `table` is the inline table or section that describes it.
MapSpec read_map_keys(TableReader& table, const std::filesystem::path& folder, bool repeats) {
  MapSpec spec;
  spec.field = table.path_of("file");
  const auto file = table.text("file");
  if (!file) table.refuse_missing("file", "the path of an image or raster");
  if (file->empty() || file->find('\0') != std::string::npos)
    table.refuse("file", "the path of an image or raster");
  spec.file = folder / *file;
  spec.spacing_m = table.number("spacing_m", kSpacingM);
  spec.nodata = table.number("nodata", kMapValue);
  spec.repeats = table.flag("repeat").value_or(repeats);
  return spec;
}

void read_channel_and_range(TableReader& table, MapSpec& spec) {
  spec.channel = table.text("channel");
  if (spec.channel && spec.channel->empty())
    table.refuse("channel", "\"R\", \"G\", \"B\", \"A\" or a channel's name");
  spec.range = table.pair("range", kMapValue);
  if (spec.range && (*spec.range)[0] == (*spec.range)[1]) {
    table.refuse("range", fmt::format("[{0}, {0}]", (*spec.range)[0]), "two different numbers");
  }
}

MapSpec read_height(TableReader& table, const std::filesystem::path& folder) {
  MapSpec spec = read_map_keys(table, folder, false);
  read_channel_and_range(table, spec);
  table.refuse_unknown_keys();
  return spec;
}

MapSpec read_density(TableReader& table, const std::filesystem::path& folder, bool repeats,
                     double default_max_per_m2) {
  MapSpec spec = read_map_keys(table, folder, repeats);
  read_channel_and_range(table, spec);
  spec.curve = table.number("curve", {0.01, 100.0}).value_or(1.0);
  spec.max = table.number("max_per_m2", {0.0, kMaxDensityPerM2}).value_or(default_max_per_m2);
  table.refuse_unknown_keys();
  return spec;
}

MapSpec read_factor(TableReader& table, const std::filesystem::path& folder, bool repeats) {
  MapSpec spec = read_map_keys(table, folder, repeats);
  read_channel_and_range(table, spec);
  spec.max = table.number("max", {0.0, 10.0}).value_or(1.0);
  table.refuse_unknown_keys();
  return spec;
}

MapSpec read_color_map(TableReader& table, const std::filesystem::path& folder, bool repeats) {
  MapSpec spec = read_map_keys(table, folder, repeats);
  table.refuse_unknown_keys();
  return spec;
}

void read_maps(TableReader& table, const std::filesystem::path& folder, bool repeats, Scene& scene) {
  if (auto map = table.table("blade_height")) scene.blade_height = read_factor(*map, folder, repeats);
  if (auto map = table.table("bend")) scene.bend = read_factor(*map, folder, repeats);
  if (auto map = table.table("color")) scene.color = read_color_map(*map, folder, repeats);
  table.refuse_unknown_keys();
}

SpeciesSpec read_species(TableReader& table, const std::filesystem::path& folder, bool repeats,
                         const std::vector<std::string>& taken) {
  SpeciesSpec spec;
  spec.species.name = read_name(table, taken);
  spec.species.params = default_species_params();
  if (const toml::node* density = table.node("density"); density != nullptr && density->is_table()) {
    TableReader map = *table.table("density");
    spec.density = read_density(map, folder, repeats, spec.uniform_density_per_m2);
  } else if (density != nullptr) {
    if (!density->is_number()) table.refuse("density", "blades per m² or a table { file = \"…\" }");
    spec.uniform_density_per_m2 = table.checked_number("density", *density, {0.0, kMaxDensityPerM2});
  }
  read_species_params(table, spec.species.params);
  read_blade_motion(table, spec.motion);
  table.refuse_unknown_keys();
  return spec;
}

// [x, y, z] with z as a number (absolute) or as text "+1.7" (above the ground).
void read_position(TableReader& table, CameraSpec& camera) {
  constexpr const char* kExpected = "[x, y, z] in metres, z as a text \"+1.7\" for above the ground";
  const toml::node* value = table.node("position_m");
  if (value == nullptr) table.refuse_missing("position_m", kExpected);
  const auto* list = value->as_array();
  if (list == nullptr || list->size() != 3) table.refuse("position_m", kExpected);
  camera.position_m.x = table.checked_number("position_m", (*list)[0], kPositionM);
  camera.position_m.y = table.checked_number("position_m", (*list)[1], kPositionM);
  const auto* text = (*list)[2].as_string();
  camera.z_above_ground = text != nullptr;
  if (text == nullptr) {
    camera.z_m = table.checked_number("position_m", (*list)[2], kPositionM);
    return;
  }
  const std::string& z = text->get();
  const char* end = z.data() + z.size();
  const auto parsed = std::from_chars(z.data() + 1, end, camera.z_m);
  const bool is_relative = z.size() > 1 && (z[0] == '+' || z[0] == '-') && z[1] != '-';
  if (!is_relative || parsed.ec != std::errc() || parsed.ptr != end || !(camera.z_m <= kPositionM.max)) {
    table.refuse("position_m", fmt::format("z as \"{}\"", printable(z)), kExpected);
  }
  if (z[0] == '-') camera.z_m = 0.0 - camera.z_m;
}

CameraSpec read_camera(TableReader& table, const std::vector<std::string>& taken) {
  CameraSpec camera;
  camera.name = read_name(table, taken);
  read_position(table, camera);
  camera.yaw_deg = table.number("yaw_deg", {-360.0, 360.0}).value_or(camera.yaw_deg);
  camera.pitch_deg = table.number("pitch_deg", {-90.0, 90.0}).value_or(camera.pitch_deg);
  camera.fov_deg = table.number("fov_deg", {1.0, 170.0}).value_or(camera.fov_deg);
  table.refuse_unknown_keys();
  return camera;
}

void read_sun(TableReader& table, SunSpec& sun) {
  sun.azimuth_deg = table.number("azimuth_deg", {-360.0, 360.0}).value_or(sun.azimuth_deg);
  sun.elevation_deg = table.number("elevation_deg", {0.0, 90.0}).value_or(sun.elevation_deg);
  sun.color = table.color("color", kLight).value_or(sun.color);
  sun.intensity = table.number("intensity", kLight).value_or(sun.intensity);
  table.refuse_unknown_keys();
}

void read_sky(TableReader& table, SunSpec& sun) {
  sun.sky_intensity = table.number("intensity", kLight).value_or(sun.sky_intensity);
  sun.haze_per_m = table.number("haze_per_m", {0.0, 1.0}).value_or(sun.haze_per_m);
  table.refuse_unknown_keys();
}

void read_lod(TableReader& table, LodSpec& lod) {
  if (const auto place = table.choice("quality", {"low", "medium", "high"}))
    lod.quality = static_cast<Quality>(*place);
  lod.blade_distance_m = table.number("blade_distance_m", {1.0, 5000.0}).value_or(lod.blade_distance_m);
  table.refuse_unknown_keys();
}

void read_version(TableReader& root) {
  const auto version = root.integer("version", 0, std::numeric_limits<std::int64_t>::max());
  if (!version) root.refuse_missing("version", fmt::format("version = {}", kVersion));
  if (*version > kVersion) {
    root.refuse("version", fmt::format("version {}, newer than this program", *version),
                fmt::format("version {} (a newer prairie reads this scene)", kVersion));
  }
  if (*version < kVersion) root.refuse("version", fmt::format("version {}", kVersion));
}

void read_ground(TableReader& root, const std::filesystem::path& folder, Scene& scene) {
  if (auto height = root.table("height")) scene.height = read_height(*height, folder);
  auto ground = root.table("ground");
  if (!ground) return;
  const auto size_m = ground->pair("size_m", kSizeM);
  if (size_m && scene.height) {
    ground->refuse("size_m", "a size beside a height map", "one of the two: the height map gives the size");
  }
  if (size_m) scene.extent_m = {(*size_m)[0], (*size_m)[1]};
  scene.soil_color = ground->color("soil_color", kAlbedo).value_or(scene.soil_color);
  ground->refuse_unknown_keys();
}

void read_all_species(TableReader& root, const std::filesystem::path& folder, Scene& scene) {
  const bool repeats = scene.height && scene.height->repeats;
  std::vector<std::string> names;
  for (TableReader& table : root.tables("species")) {
    if (scene.species.size() == kMaxSpecies) {
      root.refuse("species", fmt::format("more than {} species", kMaxSpecies),
                  fmt::format("1 to {}", kMaxSpecies));
    }
    scene.species.push_back(read_species(table, folder, repeats, names));
    names.push_back(scene.species.back().species.name);
  }
}

void read_cameras(TableReader& root, Scene& scene) {
  std::vector<std::string> names;
  for (TableReader& table : root.tables("camera")) {
    scene.cameras.push_back(read_camera(table, names));
    names.push_back(scene.cameras.back().name);
  }
}

void read_movers(TableReader& root, Scene& scene) {
  std::vector<std::string> names;
  for (TableReader& table : root.tables("mover")) {
    if (scene.movers.size() == kMaxMovers) {
      root.refuse("mover", fmt::format("more than {} movers", kMaxMovers),
                  fmt::format("at most {}", kMaxMovers));
    }
    scene.movers.push_back(read_mover(table, names));
    names.push_back(scene.movers.back().name);
  }
}

bool has_an_extent(const Scene& scene) {
  const bool has_density_map = std::any_of(scene.species.begin(), scene.species.end(),
                                           [](const SpeciesSpec& spec) { return spec.density.has_value(); });
  return scene.height || scene.extent_m.x > 0.0 || has_density_map;
}

}  // namespace

Scene scene_from_table(const toml::table& table, const TomlOrigin& origin,
                       const std::filesystem::path& folder) {
  Scene scene;
  scene.folder = folder;
  TableReader root(origin, "", table);
  read_version(root);
  const auto seed = root.integer("seed", 0, std::numeric_limits<std::int64_t>::max());
  if (seed) scene.seed = static_cast<std::uint64_t>(*seed);
  scene.tile_m = root.number("tile_m", kTileM).value_or(scene.tile_m);
  read_ground(root, folder, scene);
  read_all_species(root, folder, scene);
  const bool repeats = scene.height && scene.height->repeats;
  if (auto maps = root.table("maps")) read_maps(*maps, folder, repeats, scene);
  read_cameras(root, scene);
  if (auto sun = root.table("sun")) read_sun(*sun, scene.sun);
  if (auto sky = root.table("sky")) read_sky(*sky, scene.sun);
  if (auto lod = root.table("lod")) read_lod(*lod, scene.lod);
  if (auto wind = root.table("wind")) scene.wind = read_wind(*wind, folder);
  scene.conditions = read_conditions(root);
  if (auto treading = root.table("treading")) scene.treading = read_treading(*treading);
  read_movers(root, scene);
  read_crowd(root, scene);
  root.refuse_unknown_keys();
  if (scene.species.empty()) root.refuse_missing("species", "at least one [[species]]");
  if (!has_an_extent(scene)) {
    throw BadInput(origin.file, "ground.size_m", "nothing that says how large the ground is",
                   "a size, a height map or a density map");
  }
  return scene;
}

}  // namespace prairie
