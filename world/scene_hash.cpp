#include "world/scene_hash.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <optional>
#include <string_view>

namespace prairie {
namespace {

// The scene as text, a "name=value" line per setting. Numbers are the shortest decimals that read back as the
// same bits, so the text is the same on every machine.
class CanonicalText {
 public:
  void add(std::string_view name, double value) { line(name, fmt::format("{}", value)); }
  void add(std::string_view name, float value) { line(name, fmt::format("{}", value)); }
  void add(std::string_view name, std::uint64_t value) { line(name, fmt::format("{}", value)); }
  void add(std::string_view name, bool value) { line(name, value ? "true" : "false"); }
  // The length keeps two texts that share a line break apart.
  void add(std::string_view name, const std::string& value) {
    line(name, fmt::format("{}:{}", value.size(), value));
  }
  void add(std::string_view name, const glm::vec3& value) {
    line(name, fmt::format("{} {} {}", value.x, value.y, value.z));
  }
  void add(std::string_view name, const glm::dvec2& value) {
    line(name, fmt::format("{} {}", value.x, value.y));
  }
  void add(std::string_view name, const std::array<double, 2>& value) {
    line(name, fmt::format("{} {}", value[0], value[1]));
  }
  template <typename Value>
  void add(std::string_view name, const std::optional<Value>& value) {
    if (value) add(name, *value);
  }

  std::uint64_t hash() const { return XXH3_64bits(text_.data(), text_.size()); }

 private:
  void line(std::string_view name, std::string_view value) { text_ += fmt::format("{}={}\n", name, value); }
  std::string text_;
};

void add_map(CanonicalText& text, std::string_view name, const std::optional<MapSpec>& spec,
             const std::map<std::string, std::uint64_t>& content_hashes) {
  if (!spec) return;
  text.add("map", std::string(name));
  if (const auto content = content_hashes.find(spec->field); content != content_hashes.end()) {
    text.add("content", content->second);
  }
  text.add("channel", spec->channel);
  text.add("spacing_m", spec->spacing_m);
  text.add("range", spec->range);
  text.add("nodata", spec->nodata);
  text.add("curve", spec->curve);
  text.add("max", spec->max);
  text.add("repeats", spec->repeats);
}

void add_species(CanonicalText& text, const SpeciesSpec& spec,
                 const std::map<std::string, std::uint64_t>& content_hashes) {
  const SpeciesParams& p = spec.species.params;
  text.add("species", spec.species.name);
  add_map(text, "density", spec.density, content_hashes);
  if (!spec.density) text.add("density_per_m2", spec.uniform_density_per_m2);
  text.add("root_color", p.root_color);
  text.add("tip_color", p.tip_color);
  text.add("dry_color", p.dry_color);
  text.add("transmission", p.transmission);
  for (const float value :
       {p.dry_share, p.dry_spread, p.hue_spread, p.specular, p.height_m, p.height_spread, p.width_m,
        p.width_spread, p.tilt_rad, p.lean_rad, p.curvature_rad, p.curvature_spread, p.mass_g, p.stiffness,
        p.stiffness_spread, p.clump_m, p.clump_strength, p.clump_spray_rad}) {
    text.add("parameter", value);
  }
}

void add_camera(CanonicalText& text, const CameraSpec& camera) {
  text.add("camera", camera.name);
  text.add("position_m", camera.position_m);
  text.add("z_m", camera.z_m);
  text.add("z_above_ground", camera.z_above_ground);
  text.add("yaw_deg", camera.yaw_deg);
  text.add("pitch_deg", camera.pitch_deg);
  text.add("fov_deg", camera.fov_deg);
}

}  // namespace

std::uint64_t scene_hash(const Scene& scene, const std::map<std::string, std::uint64_t>& content_hashes) {
  CanonicalText text;
  text.add("seed", scene.seed);
  text.add("tile_m", scene.tile_m);
  text.add("extent_m", scene.extent_m);
  text.add("soil_color", scene.soil_color);
  add_map(text, "height", scene.height, content_hashes);
  for (const SpeciesSpec& spec : scene.species) add_species(text, spec, content_hashes);
  add_map(text, "blade_height", scene.blade_height, content_hashes);
  add_map(text, "bend", scene.bend, content_hashes);
  add_map(text, "color", scene.color, content_hashes);
  for (const CameraSpec& camera : scene.cameras) add_camera(text, camera);
  text.add("sun_azimuth_deg", scene.sun.azimuth_deg);
  text.add("sun_elevation_deg", scene.sun.elevation_deg);
  text.add("sun_color", scene.sun.color);
  text.add("sun_intensity", scene.sun.intensity);
  text.add("sky_intensity", scene.sun.sky_intensity);
  text.add("haze_per_m", scene.sun.haze_per_m);
  text.add("quality", static_cast<std::uint64_t>(scene.lod.quality));
  text.add("blade_distance_m", scene.lod.blade_distance_m);
  return text.hash();
}

}  // namespace prairie
