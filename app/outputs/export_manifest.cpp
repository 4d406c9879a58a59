#include "app/outputs/export_manifest.h"

#include <fmt/format.h>

#include "files/json_text.h"

namespace prairie {

std::string manifest_json(const ExportManifest& manifest) {
  JsonArray files;
  for (const ExportedFile& file : manifest.files) {
    files.push_back(JsonObject{{"file", file.name},
                               {"tile", JsonArray{file.tile.i, file.tile.j}},
                               {"view", file.view},
                               {"tier", file.tier},
                               {"blades_planted", file.blades_planted},
                               {"blades_drawn", file.blades_drawn},
                               {"sha256", file.sha256}});
  }
  // The hash as text: many readers keep numbers only up to 2^53.
  const JsonObject json{{"scene_hash", fmt::format("{:016x}", manifest.scene_hash)},
                        {"seed", manifest.seed},
                        {"time_s", manifest.time_s},
                        {"program_version", manifest.program_version},
                        {"renderer", manifest.renderer},
                        {"size_px", JsonArray{manifest.width_px, manifest.height_px}},
                        {"files", files}};
  return json_text(json) + "\n";
}

}  // namespace prairie
