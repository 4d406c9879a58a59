// `prairie new`: a scene folder to start from. Either with maps that it makes itself (rolling ground, a
// meadow of two grasses with a path and a clearing), or around a person's own rasters, which are copied
// unchanged.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace prairie {

class WorkerProcess;

/// How a person's density raster becomes blades per m²: max · clamp((v − LO)/(HI − LO), 0, 1)^curve.
struct DensityRequest {
  std::filesystem::path file;
  std::optional<std::string> channel = {};
  std::optional<double> spacing_m =
      {};  // of files without a geo-reference; else they are fitted to the ground
  std::optional<double> nodata = {};
  std::optional<std::array<double, 2>> range = {};  // default 0,1 (float files) or the type's full range
  double curve = 1.0;
  double max_per_m2 = 1000.0;
};

struct NewSceneRequest {
  std::filesystem::path folder;
  bool force = false;  // write into a folder that holds something; only the scene's own files are replaced
  std::uint64_t seed = 1;
  std::vector<std::filesystem::path> height_files;  // several, or a folder: a mosaic
  std::optional<std::array<double, 2>>
      height_range_m;  // of integer height files: heights of 0 and the largest value; of floats: 0 and 1
  std::optional<double> height_spacing_m;  // of height files without a geo-reference
  std::optional<double> height_scale;      // metres per unit of the heights
  std::optional<double> height_nodata;
  std::optional<std::array<int, 2>> height_size_px;  // of raw height files
  std::optional<std::string> height_crs;             // of height files that do not tell it
  std::optional<DensityRequest> density;             // without it, a height file gets a uniform sward
  std::uint32_t walkers = 0;                         // in a group that wanders before the default camera
  std::uint64_t memory_budget_bytes = 2ull << 30;
  WorkerProcess* decoder = nullptr;  // as of WorldOptions
};

/// Writes DIR/scene.toml and its maps; the same bytes for the same request. scene.toml comes last: a folder
/// that has one is complete. Throws UsageError (folder not empty, values out of range), BadInput (a raster
/// that cannot be used), OverBudget, OutputFailure.
/// What the scene's maps gave reason to warn of, one line each, and how a density without a place was laid.
std::vector<std::string> new_scene(const NewSceneRequest& request);

}  // namespace prairie
