#include "animation/sway.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

constexpr int kSide = layouts::kSwaySide;
constexpr std::size_t kTexels = std::size_t{kSide} * kSide;
constexpr std::size_t kLevels = layouts::kSwayLevels;

double texel_m(std::size_t level) {
  return static_cast<double>(layouts::kSwayFinestM) *
         std::pow(static_cast<double>(layouts::kSwayCoarsening), static_cast<double>(level));
}

double half_m(std::size_t level) {
  return 0.5 * kSide * texel_m(level);
}

std::size_t wrapped(int i) {
  return static_cast<std::size_t>(((i % kSide) + kSide) % kSide);
}

}  // namespace

double fade_start_m(double half) {
  return 0.75 * half;
}

double fade_end_m(double half) {
  return 0.9375 * half;
}

Sway::Sway(std::vector<SwaySpecies> species, glm::dvec2 eye_m)
    : species_(std::move(species)), centre_m_(eye_m) {
  std::vector<ChainTraits> traits;
  for (const SwaySpecies& one : species_) traits.push_back(one.traits);
  for (std::size_t level = 0; level < kLevels; ++level) {
    levels_.push_back({VirtualBlades(traits, kSide, texel_m(level), eye_m),
                       std::vector<glm::vec2>(std::size_t{kSide + 1} * (kSide + 1)),
                       std::vector<glm::vec3>(kTexels)});
  }
  image_.resize(static_cast<std::size_t>(layer_count()) * kTexels);
}

int Sway::layer_count() const {
  return static_cast<int>(kLevels * (4 * species_.size() + 1));
}

int Sway::tip_layer(std::size_t level) const {
  return static_cast<int>(kLevels * 4 * species_.size() + level);
}

std::span<glm::vec4> Sway::layer(int index) {
  return std::span(image_).subspan(static_cast<std::size_t>(index) * kTexels, kTexels);
}

void Sway::follow(glm::dvec2 eye_m) {
  centre_m_ = eye_m;
  for (Level& level : levels_) level.blades.follow(eye_m);
}

// The wind of a texel is the mean of the nodes at its corners.
void Sway::blow(Level& level, const Wind& wind, double time_s) {
  const double size_m = level.blades.texel_m();
  // The texel of the lattice that lies at the torus' first place tells where the window begins.
  const glm::dvec2 low_m = centre_m_ - 0.5 * kSide * size_m;
  const glm::ivec2 corner(static_cast<int>(std::floor(low_m.x / size_m + 0.5)),
                          static_cast<int>(std::floor(low_m.y / size_m + 0.5)));
  const WindNodes nodes{{corner.x, corner.y}, kSide + 1, kSide + 1, size_m};
  fill_wind(wind, nodes, time_s, level.nodes_m_per_s);
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const glm::vec2* south = &level.nodes_m_per_s[static_cast<std::size_t>(row * (kSide + 1) + column)];
      const glm::vec2* north = south + kSide + 1;
      const glm::vec2 mean = 0.25f * (south[0] + south[1] + north[0] + north[1]);
      const std::size_t index = wrapped(corner.y + row) * kSide + wrapped(corner.x + column);
      level.wind_m_per_s[index] = glm::vec3(mean, 0.0f);
    }
  }
}

void Sway::step(const Wind& wind, double to_s, float dt_s) {
  for (Level& level : levels_) {
    blow(level, wind, to_s);
    level.blades.step(level.wind_m_per_s, dt_s);
  }
  paint();
}

void Sway::paint() {
  // From the coarsest down: each fades into the one before.
  for (std::size_t level = kLevels; level-- > 0;) paint_level(level);
}

void Sway::paint_level(std::size_t level) {
  const VirtualBlades& blades = levels_[level].blades;
  const std::size_t count = species_.size();
  const std::span<glm::vec4> tips = layer(tip_layer(level));
  std::fill(tips.begin(), tips.end(), glm::vec4(0.0f));
  for (std::size_t s = 0; s < count; ++s) {
    const std::span<const VirtualTexel> texels = blades.texels(s);
    for (int part = 0; part < 4; ++part) {
      const std::span<glm::vec4> out = layer(static_cast<int>(4 * (level * count + s)) + part);
      for (std::size_t n = 0; n < kTexels; ++n) out[n] = texels[n].segments[static_cast<std::size_t>(part)];
    }
    const float share = species_[s].share;
    for (std::size_t n = 0; n < kTexels; ++n) {
      const auto& segments = texels[n].segments;
      tips[n] += share * glm::vec4(segments[0].w, segments[1].w, segments[2].w, 0.0f);
    }
  }

  const double start_m = fade_start_m(half_m(level)), end_m = fade_end_m(half_m(level));
  std::vector<int> layers;
  for (std::size_t n = 4 * level * count; n < 4 * (level + 1) * count; ++n) layers.push_back(static_cast<int>(n));
  layers.push_back(tip_layer(level));
  std::vector<glm::vec4> means(layers.size(), glm::vec4(0.0f));
  const bool is_last = level + 1 == kLevels;
  if (is_last) {
    for (std::size_t l = 0; l < layers.size(); ++l) {
      for (const glm::vec4& texel : layer(layers[l])) means[l] += texel;
      means[l] /= static_cast<float>(kTexels);
    }
  }
  const int layers_down = static_cast<int>(4 * count);
  for (std::size_t n = 0; n < kTexels; ++n) {
    const glm::dvec2 middle_m = blades.middle_m(n);
    const glm::dvec2 away_m = glm::abs(middle_m - centre_m_);
    const double distance_m = std::max(away_m.x, away_m.y);
    if (distance_m <= start_m) continue;
    const auto share = static_cast<float>(std::min((distance_m - start_m) / (end_m - start_m), 1.0));
    for (std::size_t l = 0; l < layers.size(); ++l) {
      const bool is_tip = l + 1 == layers.size();
      const int coarser = is_tip ? tip_layer(level + 1) : layers[l] + layers_down;
      const glm::vec4 beyond = is_last ? means[l] : sampled(coarser, level + 1, middle_m);
      glm::vec4& texel = layer(layers[l])[n];
      texel += (beyond - texel) * share;
    }
  }
}

glm::vec4 Sway::sampled(int index, std::size_t level, glm::dvec2 position_m) const {
  const double size_m = texel_m(level);
  const double x = position_m.x / size_m - 0.5, y = position_m.y / size_m - 0.5;
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  const float u = static_cast<float>(x - i), v = static_cast<float>(y - j);
  const glm::vec4* texels = &image_[static_cast<std::size_t>(index) * kTexels];
  const auto texel = [&](int di, int dj) { return texels[wrapped(j + dj) * kSide + wrapped(i + di)]; };
  const glm::vec4 south = texel(0, 0) + (texel(1, 0) - texel(0, 0)) * u;
  const glm::vec4 north = texel(0, 1) + (texel(1, 1) - texel(0, 1)) * u;
  return south + (north - south) * v;
}

namespace {

struct WindowPlace {
  std::size_t level;
  glm::dvec2 position_m;
};

// As field_place in shaders/pass/moving_fields.glsl.
WindowPlace window_place(glm::dvec2 centre_m, glm::dvec2 position_m) {
  const glm::dvec2 away_m = position_m - centre_m;
  const double distance_m = std::max(std::abs(away_m.x), std::abs(away_m.y));
  std::size_t level = 0;
  while (level + 1 < kLevels && distance_m >= fade_end_m(half_m(level))) ++level;
  // Beyond the last window a texel farther, so that no blend reaches back into it.
  const double most_m = fade_end_m(half_m(kLevels - 1)) + texel_m(kLevels - 1);
  return {level, centre_m + glm::clamp(away_m, -most_m, most_m)};
}

}  // namespace

VirtualTexel Sway::at(std::size_t species, glm::dvec2 position_m) const {
  const WindowPlace place = window_place(centre_m_, position_m);
  VirtualTexel result;
  for (int part = 0; part < 4; ++part) {
    const int index = static_cast<int>(4 * (place.level * species_.size() + species)) + part;
    result.segments[static_cast<std::size_t>(part)] = sampled(index, place.level, place.position_m);
  }
  return result;
}

glm::vec3 Sway::mean_tip(glm::dvec2 position_m) const {
  const WindowPlace place = window_place(centre_m_, position_m);
  return glm::vec3(sampled(tip_layer(place.level), place.level, place.position_m));
}

SwayState Sway::state() const {
  SwayState state{centre_m_, {}};
  state.motions.reserve(kLevels * species_.size() * kTexels);
  for (const Level& level : levels_) {
    for (std::size_t s = 0; s < species_.size(); ++s) {
      for (std::size_t n = 0; n < kTexels; ++n) state.motions.push_back(level.blades.motion(s, n));
    }
  }
  return state;
}

void Sway::restore(const SwayState& state, const Wind& wind, double time_s) {
  assert(state.motions.size() == kLevels * species_.size() * kTexels);
  follow(state.centre_m);
  auto motion = state.motions.begin();
  for (Level& level : levels_) {
    for (std::size_t s = 0; s < species_.size(); ++s) {
      for (std::size_t n = 0; n < kTexels; ++n) level.blades.set_motion(s, n, *motion++);
    }
    blow(level, wind, time_s);
    level.blades.feel(level.wind_m_per_s);
  }
  paint();
}

}  // namespace prairie
