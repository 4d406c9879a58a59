#include "app/scenes/new_scene.h"

#include <fmt/format.h>

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
#include "maps/geotiff_output.h"
#include "maps/world_file.h"
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
    write_file_atomically(staging_ / name, bytes);
    names_.push_back(name);
  }

  void copy(const fs::path& source, const std::string& name) { write(name, MappedFile(source).bytes()); }

  void finish(const std::string& scene_text) {
    write(kSceneFileName, std::string_view(scene_text));
    for (const std::string& name : names_) {
      std::error_code error;
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

// The raster, and the world file that says where it lies.
std::vector<Copy> copies_of(const fs::path& file, const std::string& name, const NewSceneRequest& request) {
  std::vector<Copy> copies{{file, name}};
  if (const auto world_file = find_world_file(file)) {
    copies.push_back({*world_file, fs::path(name).replace_extension(world_file->extension()).string()});
  }
  const auto present = find_world_file(request.folder / name);
  const bool is_replaced = present && copies.size() > 1 && present->filename() == copies.back().name;
  if (present && !is_replaced) {
    throw UsageError(kFolderArgument,
                     fmt::format("'{}', which would be read beside {}", present->string(), name),
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
};

// Opens the scene with the rasters where they lie now, and has it find a place to stand.
Found found_camera(const NewSceneRequest& request, Scene scene) {
  if (request.height_file) scene.height->file = *request.height_file;
  if (request.density) scene.species.front().density->file = request.density->file;
  WorldOptions options;
  options.memory_budget_bytes = request.memory_budget_bytes;
  const World world(std::move(scene), options);
  CameraSpec camera = world.scene().cameras.front();
  camera.position_m = {to_tenths(camera.position_m.x), to_tenths(camera.position_m.y)};
  camera.pitch_deg = to_tenths(camera.pitch_deg);
  return {camera, world.meadow().extent_m};
}

void write_from_rasters(const NewSceneRequest& request) {
  RasterNames names;
  std::vector<Copy> copies;
  const auto plan_copies = [&](const fs::path& file, const char* stem) {
    const std::string name = copy_name(stem, file);
    for (Copy& copy : copies_of(file, name, request)) copies.push_back(std::move(copy));
    return name;
  };
  if (request.height_file) names.height = plan_copies(*request.height_file, "height");
  if (request.density) names.density = plan_copies(request.density->file, "density");
  Scene scene = raster_scene(request, names);
  const auto [camera, extent_m] = found_camera(request, scene);
  scene.cameras = {camera};
  add_walkers(scene, request.walkers, extent_m);
  SceneFiles files(request.folder);
  for (const Copy& copy : copies) files.copy(copy.source, copy.name);
  files.finish(scene_text(scene, raster_notes(request)));
}

}  // namespace

void new_scene(const NewSceneRequest& request) {
  refuse_bad_numbers(request);
  refuse_occupied_folder(request);
  if (request.height_file || request.density) {
    write_from_rasters(request);
  } else {
    write_example(request);
  }
}

}  // namespace prairie
