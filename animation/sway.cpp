#include "animation/sway.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cassert>
#include <utility>

#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

constexpr int kSide = layouts::kSwaySide;
constexpr std::size_t kTexels = kWindowTexels;
constexpr std::size_t kLevels = kWindowLevels;

}  // namespace

Sway::Sway(std::vector<SwaySpecies> species, glm::dvec2 eye_m)
    : species_(std::move(species)), centre_m_(eye_m) {
  std::vector<ChainTraits> traits;
  for (const SwaySpecies& one : species_) traits.push_back(one.traits);
  for (std::size_t level = 0; level < kLevels; ++level) {
    levels_.push_back({VirtualBlades(traits, kSide, window_texel_m(level), eye_m),
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
  if (eye_m == centre_m_) return;
  centre_m_ = eye_m;
  for (Level& level : levels_) level.blades.follow(eye_m);
  paint();
}

// The wind of a texel is the mean of the nodes at its corners.
void Sway::blow(Level& level, const Wind& wind, double time_s) {
  const glm::ivec2 corner = level.blades.corner();
  const WindNodes nodes{{corner.x, corner.y}, kSide + 1, kSide + 1, level.blades.texel_m()};
  fill_wind(wind, nodes, time_s, level.nodes_m_per_s);
  tbb::parallel_for(tbb::blocked_range<int>(0, kSide, 16), [&](const auto& rows) {
    for (int row = rows.begin(); row != rows.end(); ++row) {
      for (int column = 0; column < kSide; ++column) {
        const glm::vec2* south = &level.nodes_m_per_s[static_cast<std::size_t>(row * (kSide + 1) + column)];
        const glm::vec2* north = south + kSide + 1;
        const glm::vec2 mean = 0.25f * (south[0] + south[1] + north[0] + north[1]);
        level.wind_m_per_s[window_index(corner.x + column, corner.y + row)] = glm::vec3(mean, 0.0f);
      }
    }
  });
}

void Sway::stiffen(const ConditionWindow& conditions) {
  assert(conditions.centre_m() == centre_m_);
  for (std::size_t level = 0; level < kLevels; ++level) {
    assert(levels_[level].blades.corner() == window_corner(level, centre_m_));
    const std::span<const GrassCondition> texels = conditions.texels(level);
    for (std::size_t n = 0; n < kTexels; ++n) levels_[level].blades.stiffen(n, texels[n].stiffness_factor);
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
  const std::size_t count = species_.size(), layers = 4 * count + 1;
  const bool is_last = level + 1 == kLevels;
  // The layer of each of a texel's segments and species, and of its tip; and what each fades into.
  std::vector<glm::vec4*> own(layers);
  std::vector<const glm::vec4*> coarser(is_last ? 0 : layers);
  for (std::size_t l = 0; l < layers; ++l) {
    const bool is_tip = l + 1 == layers;
    own[l] = layer(is_tip ? tip_layer(level) : static_cast<int>(4 * level * count + l)).data();
    if (!is_last)
      coarser[l] =
          layer(is_tip ? tip_layer(level + 1) : static_cast<int>(4 * (level + 1) * count + l)).data();
  }
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, kTexels, 8 * kSide), [&](const auto& range) {
    for (std::size_t n = range.begin(); n != range.end(); ++n) {
      glm::vec4 tip(0.0f);
      for (std::size_t s = 0; s < count; ++s) {
        const auto& segments = blades.texels(s)[n].segments;
        for (std::size_t part = 0; part < 4; ++part) own[4 * s + part][n] = segments[part];
        tip += species_[s].share * glm::vec4(segments[0].w, segments[1].w, segments[2].w, 0.0f);
      }
      own[layers - 1][n] = tip;
    }
  });
  fade_window(level, centre_m_, own, coarser);
}

VirtualTexel Sway::at(std::size_t species, glm::dvec2 position_m) const {
  const WindowPlace place = window_place(centre_m_, position_m);
  const WindowBlend blend = window_blend(place.level, place.position_m);
  const glm::vec4* texels = &image_[4 * (place.level * species_.size() + species) * kTexels];
  VirtualTexel result;
  for (std::size_t part = 0; part < 4; ++part) result.segments[part] = blend.of(texels + part * kTexels);
  return result;
}

glm::vec3 Sway::mean_tip(glm::dvec2 position_m) const {
  const WindowPlace place = window_place(centre_m_, position_m);
  const glm::vec4* texels = &image_[static_cast<std::size_t>(tip_layer(place.level)) * kTexels];
  return glm::vec3(window_blend(place.level, place.position_m).of(texels));
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
