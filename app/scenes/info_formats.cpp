#include "app/scenes/info_formats.h"

#include <fmt/format.h>

#include "files/joined.h"
#include "files/json_text.h"

namespace prairie {
namespace {

bool names_coordinate_system(const GeoReference& reference) {
  return !reference.wkt.empty();
}

const char* name_of(MoverKind kind) {
  return kind == MoverKind::kStone ? "stone" : "cart";
}

std::string described(const WindSpec& wind) {
  const std::string mean = wind.file
                               ? wind.file->filename().string()
                               : fmt::format("{} m/s towards {}°", wind.speed_m_per_s, wind.heading_deg);
  return fmt::format("{}, turbulence {}, {} gusts, tornadoes and breezes", mean, wind.turbulence,
                     wind.primitives.size());
}

std::string readable_bytes(std::uint64_t bytes) {
  constexpr double kMebibyte = 1024.0 * 1024.0;
  return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / kMebibyte);
}

JsonValue json_of(const SpeciesReport& species) {
  return JsonObject{{"name", species.name},
                    {"expected_blades", species.expected_blades},
                    {"mean_per_m2", species.mean_per_m2}};
}

JsonValue json_of(const LoadedMap& map) {
  return JsonObject{{"field", map.field},
                    {"file", map.file.filename().string()},
                    {"columns", map.frame.columns},
                    {"rows", map.frame.rows},
                    {"channels", map.channels},
                    {"spacing_m", map.frame.spacing_m},
                    {"origin_m", JsonArray{map.frame.origin_m.x, map.frame.origin_m.y}},
                    {"repeats", map.frame.repeats},
                    {"in_memory", map.in_memory},
                    {"memory_bytes", map.memory_bytes}};
}

JsonValue json_of(const WindSpec& wind) {
  JsonObject json;
  if (wind.file) {
    json.push_back({"file", wind.file->filename().string()});
  } else {
    json.push_back({"speed_m_per_s", wind.speed_m_per_s});
    json.push_back({"heading_deg", wind.heading_deg});
  }
  json.push_back({"turbulence", wind.turbulence});
  json.push_back({"primitives", wind.primitives.size()});
  return json;
}

JsonValue json_of(const Warning& warning) {
  return JsonObject{{"code", warning.code}, {"text", warning.text}};
}

JsonValue json_of(const MoverReport& mover) {
  return JsonObject{{"name", mover.name},
                    {"kind", name_of(mover.kind)},
                    {"speed_m_per_s", mover.speed_m_per_s},
                    {"length_m", mover.length_m},
                    {"loops", mover.loops}};
}

JsonValue json_of(const GeoReference& reference) {
  return JsonObject{{"west_m", reference.west_m},
                    {"south_m", reference.south_m},
                    {"pixel_size_m", reference.pixel_size_m},
                    {"has_coordinate_system", names_coordinate_system(reference)}};
}

template <typename Described>
JsonValue json_of(const std::optional<Described>& described) {
  return described ? json_of(*described) : JsonValue();
}

template <typename Described>
JsonValue json_of(const std::vector<Described>& described) {
  JsonArray json;
  for (const Described& one : described) json.push_back(json_of(one));
  return json;
}

}  // namespace

std::string info_text(const SceneReport& report) {
  std::string text;
  text += fmt::format("scene     {}\n", report.folder);
  text += fmt::format("hash      {:016x}, seed {}\n", report.scene_hash, report.seed);
  text += fmt::format("extent    {:.1f} × {:.1f} m{}\n", report.extent_m.x, report.extent_m.y,
                      report.repeats ? ", repeated endlessly" : "");
  text += fmt::format("tiles     {} × {} of {} m\n", report.tiles_east, report.tiles_north, report.tile_m);
  text += fmt::format("heights   {:.2f} to {:.2f} m\n", report.height_m.min_m, report.height_m.max_m);
  if (report.geo_reference) {
    text += fmt::format("origin    {:.2f} east, {:.2f} north{}\n", report.geo_reference->west_m,
                        report.geo_reference->south_m,
                        names_coordinate_system(*report.geo_reference) ? "" : ", coordinate system unknown");
  }
  for (const SpeciesReport& species : report.species) {
    text += fmt::format("species   {}: {:.0f} blades expected, {:.1f} per m²\n", species.name,
                        species.expected_blades, species.mean_per_m2);
  }
  text += fmt::format("blades    {:.0f} expected\n", report.expected_blades);
  for (const LoadedMap& map : report.maps) {
    text += fmt::format("map       {} = {}: {} × {} nodes, {} m apart, {}\n", map.field,
                        map.file.filename().string(), map.frame.columns, map.frame.rows, map.frame.spacing_m,
                        map.in_memory ? readable_bytes(map.memory_bytes) : "read from disk as needed");
  }
  text += fmt::format("memory    {} for maps\n", readable_bytes(report.map_memory_bytes));
  text += fmt::format("cameras   {}\n", joined(report.cameras, ", "));
  if (report.wind) text += fmt::format("wind      {}\n", described(*report.wind));
  if (report.conditions > 0) text += fmt::format("grass     {} conditions come over it\n", report.conditions);
  for (const MoverReport& mover : report.movers) {
    text += fmt::format("mover     {}: {}, {} m/s along {:.1f} m{}\n", mover.name, name_of(mover.kind),
                        mover.speed_m_per_s, mover.length_m, mover.loops ? ", round and round" : "");
  }
  for (const Warning& warning : report.warnings) text += fmt::format("warning   {}\n", warning.text);
  return text;
}

std::string info_json(const SceneReport& report) {
  const JsonObject json{{"folder", report.folder},
                        {"scene_hash", fmt::format("{:016x}", report.scene_hash)},
                        {"seed", report.seed},
                        {"extent_m", JsonArray{report.extent_m.x, report.extent_m.y}},
                        {"repeats", report.repeats},
                        {"tile_m", report.tile_m},
                        {"tiles", JsonArray{report.tiles_east, report.tiles_north}},
                        {"height_min_m", report.height_m.min_m},
                        {"height_max_m", report.height_m.max_m},
                        {"species", json_of(report.species)},
                        {"expected_blades", report.expected_blades},
                        {"maps", json_of(report.maps)},
                        {"map_memory_bytes", report.map_memory_bytes},
                        {"cameras", json_array(report.cameras)},
                        {"wind", json_of(report.wind)},
                        {"conditions", report.conditions},
                        {"movers", json_of(report.movers)},
                        {"geo_reference", json_of(report.geo_reference)},
                        {"warnings", json_of(report.warnings)}};
  return json_text(json) + '\n';  // paths may hold bytes that are no UTF-8
}

}  // namespace prairie
