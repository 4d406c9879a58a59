#include "world/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>

#include "files/error.h"
#include "files/input_file.h"
#include "generator/surface_density.h"
#include "world/camera_placement.h"
#include "world/effort.h"
#include "world/motion.h"
#include "world/scene/scene_hash.h"
#include "world/scene_wind.h"
#include "world/state_file.h"
#include "world/suspicions.h"

namespace prairie {
namespace {

int count_maps(const Scene& scene) {
  int count = scene.height ? 1 : 0;
  for (const SpeciesSpec& spec : scene.species) count += spec.density ? 1 : 0;
  return count + (scene.blade_height ? 1 : 0) + (scene.bend ? 1 : 0) + (scene.color ? 1 : 0);
}

glm::dvec2 extent_of(const GridFrame& frame) {
  // Where a grid repeats, its last node has the first one as its neighbour.
  const int beyond_last = frame.repeats ? 0 : 1;
  return frame.spacing_m * glm::dvec2(frame.columns - beyond_last, frame.rows - beyond_last);
}

HeightField ground_from(const MapSpec& spec, MapLoader& loader) {
  NodeGrid heights_m = loader.load_ground(spec);
  const GridFrame& frame = heights_m.frame();
  if (frame.columns < 2 || frame.rows < 2) {
    throw BadInput(spec.file.string(), spec.field, fmt::format("{} × {} nodes", frame.columns, frame.rows),
                   "at least 2 × 2");
  }
  try {
    return HeightField(std::move(heights_m));
  } catch (const BadInput& fault) {
    // The height field knows nodes, not files.
    throw BadInput(spec.file.string(), spec.field, fault.found, fault.expected);
  }
}

Meadow load_meadow(const Scene& scene, MapLoader& loader) {
  Meadow meadow;
  meadow.seed = scene.seed;
  meadow.tile_m = scene.tile_m;
  meadow.soil_color = scene.soil_color;
  meadow.extent_m = scene.extent_m;
  if (scene.height) {
    meadow.ground = ground_from(*scene.height, loader);
    meadow.extent_m = extent_of(meadow.ground.frame());
    meadow.repeats = meadow.ground.frame().repeats;
  }
  for (const SpeciesSpec& spec : scene.species) {
    NodeGrid density_per_m2 = spec.density
                                  ? loader.load(*spec.density, MapMeaning::kDensity)
                                  : NodeGrid::uniform(static_cast<float>(spec.uniform_density_per_m2));
    if (spec.density && !(meadow.extent_m.x > 0.0)) meadow.extent_m = extent_of(density_per_m2.frame());
    if (scene.density_per == DensityPer::kSurface)
      density_per_m2 = density_per_map(density_per_m2, meadow.ground);
    meadow.species.push_back({spec.species, std::move(density_per_m2)});
  }
  if (scene.blade_height) meadow.blade_height = loader.load(*scene.blade_height, MapMeaning::kFactor);
  if (scene.bend) meadow.bend = loader.load(*scene.bend, MapMeaning::kFactor);
  if (scene.color) meadow.color = loader.load(*scene.color, MapMeaning::kColor);
  if (!(meadow.extent_m.x > 0.0 && meadow.extent_m.y > 0.0)) {
    throw BadInput((scene.folder / kSceneFileName).string(), "ground.size_m", "ground without an area",
                   "a density map of at least 2 × 2 nodes, or a size");
  }
  loader.check_cover(meadow.extent_m);
  return meadow;
}

/// The ids of movers' treads lie before.
constexpr std::uint32_t kFirstWalkerTread = 1u << 20;

Crowd crowd_of(const Scene& scene, const Meadow& meadow, const Gait& gait) {
  if (scene.walkers.empty()) return Crowd(gait);
  try {
    return Crowd(scene.walkers, footprints_of(scene.standing, meadow.ground), gait, scene.seed);
  } catch (const BadInput& fault) {
    // The crowd knows no files.
    throw BadInput((scene.folder / kSceneFileName).string(), "walkers." + fault.field, fault.found,
                   fault.expected);
  }
}

}  // namespace

World::World(Scene scene, const WorldOptions& options) : scene_(std::move(scene)) {
  if (options.seed) scene_.seed = *options.seed;
  MapLoader loader(options.memory_budget_bytes, count_maps(scene_), options.decoder);
  meadow_ = load_meadow(scene_, loader);
  MapFindings& findings = loader.findings();
  if (scene_.wind && scene_.wind->file) {
    findings.content_hashes[kWindFileField] = inspect_input(*scene_.wind->file, kWindFileField).hash;
  }
  scene_hash_ = prairie::scene_hash(scene_, findings.content_hashes);
  motion_hash_ = prairie::motion_hash(scene_, findings.content_hashes);
  geo_reference_ = std::move(findings.geo_reference);
  maps_ = std::move(findings.maps);
  warnings_ = std::move(findings.warnings);
  for (const MoverSpec& spec : scene_.movers) movers_.emplace_back(spec.path);
  motion_ = std::make_unique<Motion>(scene_, meadow_);
  if (options.gait) motion_hash_ = motion_hash_with(motion_hash_, *options.gait);
  crowd_ = crowd_of(scene_, meadow_, options.gait.value_or(recorded_gait()));
  std::ranges::move(suspicions_of(scene_, meadow_, maps_), std::back_inserter(warnings_));
  if (scene_.cameras.empty()) scene_.cameras.push_back(placed_camera_spec(meadow_, "default"));
}

World::World(World&&) noexcept = default;
World::~World() = default;

void World::watch_anew(glm::dvec2 eye_m) {
  motion_->watch_anew(eye_m);
  std::vector<Solid> solids;
  for (const Mover& mover : movers_) {
    const std::vector<Solid> solid =
        solids_of(mover.path().kind, mover.path().radius_m, mover.place(meadow_.ground, time_s()));
    solids.insert(solids.end(), solid.begin(), solid.end());
  }
  motion_->meet(meadow_, solids);
}

void World::step(double wanted_s) {
  assert(wanted_s > 0.0);
  const auto ticks = std::max(std::llround(wanted_s * static_cast<double>(kTicksPerS)), 1ll);
  const double from_s = time_s(), to_s = seconds_of(motion_->ticks() + ticks);
  std::vector<TreadStep> bodies;
  std::vector<Solid> solids;
  std::vector<Footprint> footprints;
  std::uint32_t next_id = 0;
  const auto add = [&](MoverKind kind, double radius_m, const MoverPlace& from, const MoverPlace& to) {
    const std::vector<TreadStep> steps = tread_steps(kind, radius_m, from, to, next_id);
    bodies.insert(bodies.end(), steps.begin(), steps.end());
    const std::vector<Solid> solid = solids_of(kind, radius_m, to);
    solids.insert(solids.end(), solid.begin(), solid.end());
    next_id += kTreadIdsPerMover;
    footprints.push_back(footprint_of(kind, radius_m, to));
  };
  for (const Mover& mover : movers_) {
    add(mover.path().kind, mover.path().radius_m, mover.place(meadow_.ground, from_s),
        mover.place(meadow_.ground, to_s));
  }
  for (const DrivenMover& driven : driven_) add(driven.kind, driven.radius_m, driven.before, driven.place);
  const double dt_s = seconds_of(ticks);
  const auto effort = [this](glm::dvec2 place_m) { return effort_at(meadow_, place_m); };
  const std::vector<TreadStep> feet =
      replay_ ? replay_->step(meadow_.ground, to_s, dt_s, kFirstWalkerTread)
              : crowd_.step({meadow_.ground, footprints, effort}, from_s, dt_s, kFirstWalkerTread);
  bodies.insert(bodies.end(), feet.begin(), feet.end());
  motion_->step(meadow_, ticks, bodies, solids);
  for (DrivenMover& driven : driven_) driven.before = driven.place;
}

double World::time_s() const {
  return motion_->time_s();
}

void World::replay(std::vector<Track> tracks) {
  assert(motion_->ticks() == 0 && !replay_);
  motion_hash_ = motion_hash_with(motion_hash_, tracks);
  replay_.emplace(std::move(tracks), crowd_.gait(), scene_.seed, 0.0);
  crowd_ = Crowd(crowd_.gait());
}

std::vector<Percept> World::percepts() const {
  std::vector<Footprint> footprints;
  for (const Mover& mover : movers_) {
    const MoverPath& path = mover.path();
    footprints.push_back(footprint_of(path.kind, path.radius_m, mover.place(meadow_.ground, time_s())));
  }
  for (const DrivenMover& driven : driven_)
    footprints.push_back(footprint_of(driven.kind, driven.radius_m, driven.place));
  return crowd_.percepts(footprints);
}

std::vector<std::byte> World::saved_state() const {
  return state_bytes({motion_->state(), {walkers().begin(), walkers().end()}},
                     {motion_hash_, scene_.treading});
}

void World::load_state(std::span<const std::byte> bytes, const std::string& file) {
  WorldState state = parse_state(bytes, {motion_hash_, scene_.treading}, file);
  try {
    // All that may be refused comes before anything changes.
    Crowd crowd = crowd_;
    std::optional<ReplayedWalkers> replay = replay_;
    if (replay) {
      replay->restore(state.walkers, seconds_of(state.motion.ticks));
    } else {
      crowd.restore(std::move(state.walkers));
    }
    motion_->restore(meadow_, std::move(state.motion));
    crowd_ = std::move(crowd);
    replay_ = std::move(replay);
  } catch (const BadInput& fault) {
    // What moves knows no files.
    throw BadInput(file, fault.field, fault.found, fault.expected);
  }
}

}  // namespace prairie
