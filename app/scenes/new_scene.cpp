#include "app/scenes/new_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/scenes/new_scene_contents.h"
#include "app/scenes/new_scene_notes.h"
#include "app/terminal/interruption.h"
#include "app/terminal/usage_error.h"
#include "files/atomic_file.h"
#include "files/mapped_file.h"
#include "maps/georaster/vrt_sources.h"
#include "maps/geotiff_output.h"
#include "maps/map_files.h"
#include "maps/map_work.h"
#include "pictures/picture_encoding.h"
#include "world/example_meadow.h"
#include "world/world.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolderArgument = "DIR";

// Files of the new scene. They are written beside their places and all put there in the end, scene.toml last:
// if one cannot be written, the folder is as it was.
class SceneFiles {
 public:
  explicit SceneFiles(fs::path folder) : folder_(std::move(folder)), staging_(folder_ / ".new-scene") {
    std::error_code error;
    is_new_folder_ = fs::create_directories(folder_, error);
    if (!error) fs::create_directory(staging_, error);
    if (error) {
      remove_traces();
      throw OutputFailure(folder_.string(), "", error.message(), "a folder that can be written");
    }
  }
  ~SceneFiles() { remove_traces(); }
  SceneFiles(const SceneFiles&) = delete;
  SceneFiles& operator=(const SceneFiles&) = delete;

  template <typename Bytes>
  void write(const std::string& name, const Bytes& bytes) {
    std::error_code ignored;  // the write tells of a folder that could not be made
    fs::create_directories((staging_ / name).parent_path(), ignored);
    write_file_atomically(staging_ / name, bytes);
    names_.push_back(name);
  }

  void copy(const fs::path& source, const std::string& name) { write(name, MappedFile(source).bytes()); }

  void finish(const std::string& scene_text) {
    write(kSceneFileName, std::string_view(scene_text));
    for (const std::string& name : names_) {
      std::error_code error;
      fs::create_directories((folder_ / name).parent_path(), error);
      fs::rename(staging_ / name, folder_ / name, error);
      if (error)
        throw OutputFailure((folder_ / name).string(), "", error.message(), "a file that can be replaced");
      is_new_folder_ = false;
    }
  }

 private:
  void remove_traces() {
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
    if (is_new_folder_) fs::remove(folder_, ignored);
  }

  UninterruptedWrite uninterrupted_;
  fs::path folder_;
  fs::path staging_;
  std::vector<std::string> names_;
  bool is_new_folder_ = false;
};

void refuse_occupied_folder(const NewSceneRequest& request) {
  std::error_code error;
  const fs::file_status status = fs::status(request.folder, error);
  if (!fs::exists(status)) return;
  const std::string folder = request.folder.string();
  if (!fs::is_directory(status))
    throw UsageError(kFolderArgument, fmt::format("'{}', a file", folder), "a folder");
  const bool is_empty = fs::is_empty(request.folder, error);
  if (error) throw OutputFailure(folder, "", error.message(), "a folder that can be read");
  if (!is_empty && !request.force) {
    throw UsageError(kFolderArgument, fmt::format("'{}', which is not empty", folder),
                     "a new or empty folder, or --force");
  }
}

void refuse_bad_numbers(const NewSceneRequest& request) {
  constexpr auto kLargestSeed = std::numeric_limits<std::int64_t>::max();  // of a TOML number
  if (request.seed > static_cast<std::uint64_t>(kLargestSeed)) {
    throw UsageError("--seed", fmt::format("{}", request.seed),
                     fmt::format("at most {} in a scene file", kLargestSeed));
  }
}

std::vector<std::byte> encoded(const GreyMap& map) {
  return encode_png_grey8(map.columns, map.rows, map.values);
}

void write_example(const NewSceneRequest& request) {
  const ExampleMeadow meadow = make_example_meadow(request.seed);
  SceneFiles files(request.folder);
  files.write(kExampleGroundFile, std::span<const std::byte>(encode_geotiff(meadow.ground_m, nullptr)));
  files.write(kExampleFescueFile, std::span<const std::byte>(encoded(meadow.fescue_per_m2)));
  files.write(kExampleOatgrassFile, std::span<const std::byte>(encoded(meadow.oatgrass_per_m2)));
  files.write(kExampleBladeHeightFile, std::span<const std::byte>(encoded(meadow.blade_height)));
  const GridFrame& frame = meadow.ground_m.frame();
  const glm::dvec2 extent_m = frame.spacing_m * glm::dvec2(frame.columns - 1, frame.rows - 1);
  Scene scene = example_scene(request, meadow);
  add_walkers(scene, request.walkers, extent_m);
  files.finish(scene_text(scene, example_notes()));
}

// The stem says what the raster is; the suffix, which readers go by, stays if it is a plain one.
std::string copy_name(const char* stem, const fs::path& file) {
  const std::string suffix = file.extension().string();
  for (std::size_t k = 1; k < suffix.size(); ++k) {
    if (!std::isalnum(static_cast<unsigned char>(suffix[k]))) return stem;
  }
  return stem + suffix;
}

struct Copy {
  fs::path source;
  std::string name;
};

// The name of a tile of SRTM says where it lies.
bool is_named_by_place(const fs::path& file) {
  const std::string suffix = file.extension().string();
  return suffix == ".hgt" || suffix == ".HGT";
}

// The raster's companions are found by its name, or, those of a VRT, by their places below it.
std::vector<Copy> copies_of(const fs::path& file, const std::string& name, const std::string& field,
                            const NewSceneRequest& request) {
  std::vector<Copy> copies{{file, name}};
  const std::string stem = file.stem().string();
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  for (const fs::path& companion : companions_of(file, field)) {
    const std::string own_name = companion.filename().string();
    std::error_code ignored;
    const bool is_beside =
        fs::equivalent(companion.parent_path().empty() ? fs::path(".") : companion.parent_path(), folder,
                       ignored) &&
        own_name.starts_with(stem + ".") && !is_vrt(companion);
    const fs::path copied = is_beside
                                ? fs::path(fs::path(name).stem().string() + own_name.substr(stem.size()))
                                : fs::relative(companion, fs::canonical(folder, ignored), ignored);
    copies.push_back({companion, copied.string()});
  }
  for (const fs::path& companion : companions_of(request.folder / name, field)) {
    const auto is_it = [&](const Copy& copy) { return companion == request.folder / copy.name; };
    if (std::ranges::any_of(copies, is_it)) continue;
    throw UsageError(kFolderArgument,
                     fmt::format("'{}', which would be read beside {}", companion.string(), name),
                     "a folder without it");
  }
  return copies;
}

double to_tenths(double value) {
  return std::round(10.0 * value) / 10.0;
}

struct Found {
  CameraSpec camera;
  glm::dvec2 extent_m;
  std::vector<Warning> warnings;
};

// Opens the scene with the rasters where they lie now, and has it find a place to stand.
Found found_camera(const NewSceneRequest& request, Scene scene) {
  if (scene.height) {
    scene.height->file = request.height_files.front();
    scene.height->more_files.assign(request.height_files.begin() + 1, request.height_files.end());
  }
  if (request.density) scene.species.front().density->file = request.density->file;
  WorldOptions options;
  options.memory_budget_bytes = request.memory_budget_bytes;
  options.decoder = request.decoder;
  const World world(std::move(scene), options);
  CameraSpec camera = world.scene().cameras.front();
  camera.position_m = {to_tenths(camera.position_m.x), to_tenths(camera.position_m.y)};
  camera.pitch_deg = to_tenths(camera.pitch_deg);
  return {camera, world.meadow().extent_m, world.warnings()};
}

MapSpec spec_of_ground(const NewSceneRequest& request) {
  MapSpec spec;
  spec.file = request.height_files.front();
  spec.more_files.assign(request.height_files.begin() + 1, request.height_files.end());
  spec.field = "height.file";
  spec.spacing_m = request.height_spacing_m;
  spec.size_px = request.height_size_px;
  spec.crs = request.height_crs;
  return spec;
}

// A mask without a place that comes with a ground belongs onto it, as terrain tools deliver them. Returns
// what was done, if anything was.
std::string fit_density(NewSceneRequest& request) {
  DensityRequest& density = *request.density;
  if (density.spacing_m) return "";
  if (request.height_files.empty()) {
    // Level ground has no other map that says how large a pixel is.
    density.spacing_m = request.height_spacing_m;
    return "";
  }
  MapSpec spec;
  spec.file = density.file;
  spec.field = "species.0.density.file";
  const MapLayout mask =
      layout_of_map({.spec = spec, .meaning = MapMeaning::kDensity, .scene_wkt = ""}, request.decoder);
  if (mask.spacing_m) return "";
  const MapLayout ground = layout_of_map(
      {.spec = spec_of_ground(request), .meaning = MapMeaning::kHeight, .scene_wkt = ""}, request.decoder);
  if (!ground.spacing_m) return "";  // which opening the scene refuses, with its reason
  const double east_m = *ground.spacing_m * ground.columns / mask.columns;
  const double north_m = *ground.spacing_m * ground.rows / mask.rows;
  constexpr double kSameShape = 0.02;
  if (std::abs(east_m - north_m) > kSameShape * east_m) {
    throw BadInput(density.file.string(), spec.field,
                   fmt::format("{} × {} pixels for a ground of {} × {} nodes", mask.columns, mask.rows,
                               ground.columns, ground.rows),
                   "a mask of the ground's shape, or --density-spacing, the metres between its pixels");
  }
  // Its outermost nodes lie on those of the ground, or beyond.
  const auto spacing_for = [&](int ground_nodes, int mask_nodes) {
    return *ground.spacing_m * (ground_nodes - 1) / std::max(mask_nodes - 1, 1);
  };
  density.spacing_m =
      std::max(spacing_for(ground.columns, mask.columns), spacing_for(ground.rows, mask.rows));
  return fmt::format("{}: the density tells no place: fitted to the ground, {:.6g} m between its pixels",
                     density.file.string(), *density.spacing_m);
}

std::vector<std::string> write_from_rasters(NewSceneRequest request) {
  std::vector<std::string> notes;
  if (request.density) notes.push_back(fit_density(request));
  RasterNames names;
  std::vector<Copy> copies;
  const auto plan_copies = [&](const fs::path& file, const std::string& name, const char* field) {
    for (Copy& copy : copies_of(file, name, field, request)) copies.push_back(std::move(copy));
    return name;
  };
  if (!request.height_files.empty()) {
    MapSpec spec = spec_of_ground(request);
    request.height_files = files_of_map(spec);
    for (const fs::path& file : request.height_files) {
      const bool is_alone = request.height_files.size() == 1;
      names.heights.push_back(plan_copies(
          file, is_alone && !is_named_by_place(file) ? copy_name("height", file) : file.filename().string(),
          "height.file"));
    }
  }
  if (request.density)
    names.density = plan_copies(request.density->file, copy_name("density", request.density->file),
                                "species.0.density.file");
  Scene scene = raster_scene(request, names);
  Found found = found_camera(request, scene);
  scene.cameras = {found.camera};
  add_walkers(scene, request.walkers, found.extent_m);
  SceneFiles files(request.folder);
  for (const Copy& copy : copies) files.copy(copy.source, copy.name);
  files.finish(scene_text(scene, raster_notes(request)));
  for (const Warning& warning : found.warnings) notes.push_back(warning.text);
  std::erase(notes, "");
  return notes;
}

}  // namespace

std::vector<std::string> new_scene(const NewSceneRequest& request) {
  refuse_bad_numbers(request);
  refuse_occupied_folder(request);
  if (!request.height_files.empty() || request.density) return write_from_rasters(request);
  write_example(request);
  return {};
}

}  // namespace prairie
