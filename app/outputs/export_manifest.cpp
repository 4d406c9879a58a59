#include "app/outputs/export_manifest.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace prairie {

std::string manifest_json(const ExportManifest& manifest) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const ExportedFile& file : manifest.files) {
    files.push_back({{"file", file.name},
                     {"tile", {file.tile.i, file.tile.j}},
                     {"view", file.view},
                     {"tier", file.tier},
                     {"blades_planted", file.blades_planted},
                     {"blades_drawn", file.blades_drawn},
                     {"sha256", file.sha256}});
  }
  // The hash as text: many readers keep numbers only up to 2^53.
  const nlohmann::ordered_json json{{"scene_hash", fmt::format("{:016x}", manifest.scene_hash)},
                                    {"seed", manifest.seed},
                                    {"time_s", manifest.time_s},
                                    {"program_version", manifest.program_version},
                                    {"renderer", manifest.renderer},
                                    {"size_px", {manifest.width_px, manifest.height_px}},
                                    {"files", files}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace prairie
