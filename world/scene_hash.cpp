#include "world/scene_hash.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <optional>
#include <string_view>
#include <variant>

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
  void add(std::string_view name, const glm::dvec3& value) {
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
  text.add("damping_ratio", spec.motion.damping_ratio);
  text.add("drag_coefficient", spec.motion.drag_coefficient);
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

void add_primitive(CanonicalText& text, const Gust& gust) {
  text.add("gust", gust.origin_m);
  for (const double value : {gust.heading_rad, gust.travel_m_per_s, gust.strength_m_per_s, gust.width_m,
                             gust.depth_m, gust.way_m, gust.start_s}) {
    text.add("parameter", value);
  }
}

void add_primitive(CanonicalText& text, const Tornado& tornado) {
  text.add("tornado", tornado.origin_m);
  for (const double value : {tornado.heading_rad, tornado.travel_m_per_s, tornado.strength_m_per_s,
                             tornado.radius_m, tornado.reach_m, tornado.inflow, tornado.wander_m,
                             tornado.wander_s, tornado.start_s, tornado.duration_s}) {
    text.add("parameter", value);
  }
  text.add("seed", std::uint64_t{tornado.seed});
}

void add_primitive(CanonicalText& text, const Breeze& breeze) {
  text.add("breeze", breeze.origin_m);
  for (const double value :
       {breeze.heading_rad, breeze.strength_m_per_s, breeze.period_s, breeze.wavelength_m, breeze.radius_m}) {
    text.add("parameter", value);
  }
}

void add_wind(CanonicalText& text, const std::optional<WindSpec>& wind,
              const std::map<std::string, std::uint64_t>& content_hashes) {
  if (!wind) return;
  text.add("wind", wind->turbulence);
  if (wind->file) {
    if (const auto content = content_hashes.find(kWindFileField); content != content_hashes.end())
      text.add("content", content->second);
    text.add("place_m", wind->place_m);
  } else {
    text.add("speed_m_per_s", wind->speed_m_per_s);
    text.add("heading_deg", wind->heading_deg);
  }
  for (const WindPrimitive& primitive : wind->primitives)
    std::visit([&](const auto& one) { add_primitive(text, one); }, primitive);
}

void add_condition(CanonicalText& text, const Condition& condition) {
  text.add("condition", condition.centre_m);
  text.add("velocity_m_per_s", condition.velocity_m_per_s);
  for (const double value : {condition.radius_m, condition.edge_m, condition.start_s, condition.duration_s,
                             condition.fade_s, condition.stiffness_factor}) {
    text.add("parameter", value);
  }
  text.add("color_factor", condition.color_factor);
}

void add_treading(CanonicalText& text, const TreadSettings& treading) {
  text.add("spacing_m", treading.spacing_m);
  text.add("reach_radii", treading.reach_radii);
  text.add("recovery_s", treading.recovery_s);
  for (const float value : {treading.field_scale, treading.most_tilt_rad, treading.load_slowing,
                            treading.worn_slowing, treading.wear_passes, treading.worn_field}) {
    text.add("treading", value);
  }
}

void add_mover(CanonicalText& text, const MoverSpec& mover) {
  text.add("mover", mover.name);
  text.add("kind", static_cast<std::uint64_t>(mover.path.kind));
  text.add("radius_m", mover.path.radius_m);
  text.add("speed_m_per_s", mover.path.speed_m_per_s);
  text.add("start_s", mover.path.start_s);
  text.add("loops", mover.path.loops);
  for (const glm::dvec2 point_m : mover.path.path_m) text.add("point_m", point_m);
}

void add_obstacle(CanonicalText& text, const Trunk& trunk) {
  text.add("trunk", trunk.position_m);
  text.add("radius_m", trunk.radius_m);
  text.add("height_m", trunk.height_m);
}

void add_obstacle(CanonicalText& text, const Block& block) {
  text.add("box", block.position_m);
  text.add("size_m", block.size_m);
  text.add("heading_rad", block.heading_rad);
}

void add_obstacle(CanonicalText& text, const Rock& rock) {
  text.add("rock", rock.position_m);
  text.add("size_m", rock.size_m);
  text.add("heading_rad", rock.heading_rad);
  text.add("seed", std::uint64_t{rock.seed});
}

void add_wall(CanonicalText& text, const Wall& wall) {
  text.add("wall", static_cast<std::uint64_t>(wall.walkers));
  text.add("height_m", wall.height_m);
  for (const glm::dvec2 point_m : wall.outline.outer_m) text.add("outer_m", point_m);
  for (const auto& hole_m : wall.outline.holes_m) {
    text.add("hole", static_cast<std::uint64_t>(hole_m.size()));
    for (const glm::dvec2 point_m : hole_m) text.add("hole_m", point_m);
  }
}

void add_walkers(CanonicalText& text, const WalkerGroup& group) {
  text.add("walkers", group.name);
  text.add("count", std::uint64_t{group.count});
  text.add("behaviour", group.behaviour);
  for (const Goal& goal : group.goals) {
    text.add("goal", goal.position_m);
    text.add("radius_m", goal.radius_m);
    text.add("stay_s", goal.stay_s);
  }
  text.add("centre_m", group.centre_m);
  for (const glm::dvec2 start_m : group.starts_m) text.add("start_m", start_m);
  for (const double value : {group.radius_m, group.speed_m_per_s, group.speed_spread, group.height_m,
                             group.height_spread, group.body_radius_m, group.sensor_m, group.noise}) {
    text.add("parameter", value);
  }
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
  add_wind(text, scene.wind, content_hashes);
  for (const Condition& condition : scene.conditions) add_condition(text, condition);
  add_treading(text, scene.treading);
  for (const MoverSpec& mover : scene.movers) add_mover(text, mover);
  for (const Obstacle& obstacle : scene.standing.obstacles)
    std::visit([&](const auto& one) { add_obstacle(text, one); }, obstacle);
  for (const Wall& wall : scene.standing.walls) add_wall(text, wall);
  for (const WalkerGroup& group : scene.walkers) add_walkers(text, group);
  return text.hash();
}

std::uint64_t motion_hash(const Scene& scene, const std::map<std::string, std::uint64_t>& content_hashes) {
  Scene unseen = scene;
  unseen.cameras.clear();
  unseen.sun = SunSpec{};
  unseen.lod = LodSpec{};
  return scene_hash(unseen, content_hashes);
}

std::uint64_t motion_hash_with(std::uint64_t motion_hash, const Gait& gait) {
  CanonicalText text;
  text.add("scene", motion_hash);
  for (const double value : {gait.speed_m_per_s, gait.period_s, gait.stance, gait.lead, gait.half_width})
    text.add("gait", value);
  for (const auto& curve : gait.keys) {
    for (const double key : curve) text.add("key", key);
  }
  return text.hash();
}

std::uint64_t motion_hash_with(std::uint64_t motion_hash, const std::vector<Track>& tracks) {
  CanonicalText text;
  text.add("scene", motion_hash);
  for (const Track& track : tracks) {
    text.add("track", static_cast<std::uint64_t>(track.id));
    text.add("times",
             std::uint64_t{XXH3_64bits(track.times_s.data(), track.times_s.size() * sizeof(double))});
    text.add("places", std::uint64_t{XXH3_64bits(track.positions_m.data(),
                                                 track.positions_m.size() * sizeof(glm::dvec2))});
  }
  return text.hash();
}

}  // namespace prairie
