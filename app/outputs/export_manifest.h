// manifest.json of exported tile screenshots: what made them and what each file is. The same pictures give
// the same bytes, whenever, wherever and by whomever they were made: no clock time, host name or absolute
// path.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/tiles.h"

namespace prairie {

struct ExportedFile {
  std::string name;
  TileId tile;
  std::string view;
  std::string tier;
  std::uint64_t blades_planted = 0;
  std::uint64_t blades_drawn = 0;
  std::string sha256;
};

struct ExportManifest {
  std::uint64_t scene_hash = 0;
  std::uint64_t seed = 0;
  double time_s = 0.0;  // of the scene, not of a clock
  std::string program_version;
  std::string renderer;
  int width_px = 0;
  int height_px = 0;
  std::vector<ExportedFile> files;
};

/// Indented JSON, keys in a fixed order, ending in a line break.
std::string manifest_json(const ExportManifest& manifest);

}  // namespace prairie
