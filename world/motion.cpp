#include "world/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "animation/blade_checks.h"
#include "animation/range_check.h"
#include "animation/tread_checks.h"
#include "files/error.h"
#include "shaders/shared/layouts.h"
#include "world/scene_wind.h"

namespace prairie {
namespace {

// Blades forget what moved them within a few of their swings.
constexpr int kWarmUpSteps = 150;
constexpr std::int64_t kWarmUpTicks = kTicksPerS / 30;
constexpr std::size_t kMostSpawned = 256;
// An eye that jumps farther sees grass that it has not seen before.
constexpr double kJumpM = 24.0;

constexpr int kDensitySamples = 32;  // along a side of the field

std::vector<SwaySpecies> sway_species(const Scene& scene, const Meadow& meadow) {
  std::vector<SwaySpecies> species;
  double sum = 0.0;
  for (std::size_t n = 0; n < scene.species.size(); ++n) {
    const SpeciesParams& params = scene.species[n].species.params;
    // By the leaf area that is seen of it.
    const double area = mean_density_per_m2(meadow.species[n], meadow.extent_m, kDensitySamples) *
                        static_cast<double>(params.height_m * params.width_m);
    species.push_back({chain_traits_of(scene.species[n]), static_cast<float>(area)});
    sum += area;
  }
  for (SwaySpecies& one : species) {
    one.share = sum > 0.0 ? static_cast<float>(static_cast<double>(one.share) / sum)
                          : 1.0f / static_cast<float>(species.size());
  }
  return species;
}

// Behind the scene's own, which stay: a state of an earlier time may bring them back. Those that are over,
// and the oldest of too many, go.
template <class Spawned>
void add_spawned(std::vector<Spawned>& all, std::size_t of_scene, const Spawned& one, double time_s) {
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(of_scene);
  all.erase(std::remove_if(first, all.end(), [&](const Spawned& old) { return end_s(old) < time_s; }),
            all.end());
  if (all.size() >= of_scene + kMostSpawned) all.erase(all.begin() + static_cast<std::ptrdiff_t>(of_scene));
  all.push_back(one);
}

}  // namespace

Motion::Motion(const Scene& scene, const Meadow& meadow)
    : has_wind_(scene.wind.has_value()),
      species_(sway_species(scene, meadow)),
      wind_(wind_of(scene, 0.5 * meadow.extent_m)),
      treading_(scene.treading),
      conditions_(scene.conditions),
      scene_primitives_(wind_.primitives.size()),
      scene_conditions_(conditions_.size()) {
  for (const SwaySpecies& one : species_) traits_.push_back(one.traits);
}

bool Motion::blows() const {
  return has_wind_ || !wind_.primitives.empty();
}

void Motion::spawn(const WindPrimitive& primitive) {
  check(primitive, "gust");
  add_spawned(wind_.primitives, scene_primitives_, primitive, time_s());
  begin_to_sway();
}

void Motion::set_wind(const MeanWind& mean, const std::optional<NoiseWind>& noise) {
  wind_.mean = mean;
  wind_.noise = noise;
  has_wind_ = true;
  begin_to_sway();
}

void Motion::begin_to_sway() {
  if (!eye_m_ || sway_) return;
  sway_.emplace(species_, *eye_m_);
  if (conditions() != nullptr) sway_->stiffen(*conditions());
}

void Motion::spawn(const Condition& condition) {
  check(condition, "condition");
  add_spawned(conditions_, scene_conditions_, condition, time_s());
  show_conditions();
}

// Blades that sway stand around the same eye.
void Motion::show_conditions() {
  if (!eye_m_ || conditions_.empty()) return;
  if (!condition_window_) condition_window_.emplace(*eye_m_);
  const bool has_changed = condition_window_->show(conditions_, *eye_m_, time_s());
  if (has_changed && sway_) sway_->stiffen(*condition_window_);
}

void Motion::wake(bool stirs) {
  wind_.wake.reset();
  if (stirs) wind_.wake.emplace(CameraWakeSettings{});
}

// Grass in calm air has nothing to sway in until the eye first moves.
void Motion::stir() {
  if (!wind_.wake || !eye_m_) return;
  wind_.wake->step(*eye_m_, time_s());
  if (sway_) return;
  const std::vector<glm::vec2>& velocities = wind_.wake->state().velocities_m_per_s;
  if (std::ranges::any_of(velocities, [](glm::vec2 velocity) { return velocity != glm::vec2(0.0f); }))
    begin_to_sway();
}

void Motion::watch_anew(glm::dvec2 eye_m) {
  eye_m_ = eye_m;
  sway_.reset();
  touched_ = TouchedBlades();  // those that another eye saw
  show_conditions();
  if (!blows()) return;
  // In what has come over the grass by now, as if it had long been there.
  begin_to_sway();
  const std::optional<CameraWake> wake =
      std::exchange(wind_.wake, std::nullopt);  // of another time and place
  for (std::int64_t n = kWarmUpSteps; n-- > 0;)
    sway_->step(wind_, seconds_of(ticks_ - n * kWarmUpTicks), static_cast<float>(seconds_of(kWarmUpTicks)));
  wind_.wake = wake;
}

void Motion::watch(glm::dvec2 eye_m) {
  const bool has_jumped =
      !eye_m_ || glm::any(glm::greaterThan(glm::abs(eye_m - *eye_m_), glm::dvec2(kJumpM)));
  if (has_jumped) return watch_anew(eye_m);
  eye_m_ = eye_m;
  if (sway_) sway_->follow(eye_m);
  show_conditions();
}

Surroundings Motion::surroundings(const Meadow& meadow) const {
  return {meadow, traits_, wind_, treading_, sway_ ? &*sway_ : nullptr, time_s(), conditions()};
}

void Motion::meet(const Meadow& meadow, std::span<const Solid> solids) {
  if (eye_m_) touched_.meet(surroundings(meadow), solids, *eye_m_);
}

void Motion::step(const Meadow& meadow, std::int64_t ticks, std::span<const TreadStep> bodies,
                  std::span<const Solid> solids) {
  treading_.step(bodies, seconds_of(ticks_ + ticks));
  ticks_ += ticks;
  const auto dt_s = static_cast<float>(seconds_of(ticks));
  stir();
  show_conditions();
  if (sway_) sway_->step(wind_, time_s(), dt_s);
  if (eye_m_) touched_.step(surroundings(meadow), solids, *eye_m_, dt_s);
}

MotionState Motion::state() const {
  MotionState state{ticks_, treading_.state(), eye_m_, std::nullopt, touched_.state()};
  if (sway_) state.sway = sway_->state();
  return state;
}

void Motion::restore(const Meadow& meadow, MotionState state) {
  constexpr std::int64_t kMostTicks = kTicksPerS * std::int64_t{1'000'000'000};
  if (state.ticks < 0 || state.ticks > kMostTicks)
    throw BadInput("", "time", fmt::format("{} ticks", state.ticks), "not negative, at most 10⁹ seconds");
  if (state.treading.time_s != seconds_of(state.ticks))
    throw BadInput("", "treading.time_s", fmt::format("{}", state.treading.time_s),
                   fmt::format("{}, the state's", seconds_of(state.ticks)));
  if (state.eye_m) {
    check_range("eye_m", state.eye_m->x, -kFarthestM, kFarthestM, "metres");
    check_range("eye_m", state.eye_m->y, -kFarthestM, kFarthestM, "metres");
  } else if (state.sway || !state.touched.empty()) {
    throw BadInput("", "eye_m", "moving blades without an eye", "an eye that watches them");
  }
  if (state.sway) {
    const std::size_t count =
        layouts::kSwayLevels * species_.size() * layouts::kSwaySide * layouts::kSwaySide;
    if (state.sway->motions.size() != count)
      throw BadInput("", "sway", fmt::format("{} blades", state.sway->motions.size()),
                     fmt::format("{}, for this scene's species", count));
    if (state.sway->centre_m != *state.eye_m)
      throw BadInput("", "sway.centre_m", "another place", "the eye's");
    check_state(*state.sway);
  }
  TouchedBlades touched;
  touched.restore(state.touched, meadow);
  treading_.restore(std::move(state.treading));

  // From here on nothing is refused.
  ticks_ = state.ticks;
  eye_m_ = state.eye_m;
  wake(false);
  sway_.reset();
  if (state.sway) {
    show_conditions();
    begin_to_sway();
    sway_->restore(*state.sway, wind_, time_s());
  } else if (eye_m_) {
    watch_anew(*eye_m_);  // in case that by now it blows
  }
  touched_ = std::move(touched);
  touched_.pose(surroundings(meadow));
}

}  // namespace prairie
