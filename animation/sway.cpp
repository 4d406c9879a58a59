#include "animation/sway.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
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
  const glm::ivec2 corner = level.blades.corner();
  const WindNodes nodes{{corner.x, corner.y}, kSide + 1, kSide + 1, level.blades.texel_m()};
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

namespace {

/// What lies between four texels of a torus, bilinear.
struct TexelBlend {
  std::array<std::size_t, 4> from;  // south-west, south-east, north-west, north-east
  float east, north;

  glm::vec4 of(const glm::vec4* texels) const {
    const glm::vec4 south = texels[from[0]] + (texels[from[1]] - texels[from[0]]) * east;
    const glm::vec4 norths = texels[from[2]] + (texels[from[3]] - texels[from[2]]) * east;
    return south + (norths - south) * north;
  }
};

/// Along an axis: the texel before a place, and the share of the way to the next one.
struct Between {
  std::size_t before, after;
  float share;
};

Between between(double position_m, double size_m) {
  const double at = position_m / size_m - 0.5, below = std::floor(at);
  const int index = static_cast<int>(below);
  return {wrapped(index), wrapped(index + 1), static_cast<float>(at - below)};
}

TexelBlend blend_of(const Between& column, const Between& row) {
  return {{row.before * kSide + column.before, row.before * kSide + column.after, row.after * kSide + column.before,
           row.after * kSide + column.after},
          column.share,
          row.share};
}

/// Along an axis, of a texel of a torus: how far from the centre, and where in the next coarser window.
struct Place {
  double away_m;
  Between coarser;
};

std::array<Place, kSide> places_along(int corner, double size_m, double centre_m) {
  std::array<Place, kSide> places;
  for (int n = 0; n < kSide; ++n) {
    const double middle_m = (corner + n + 0.5) * size_m;
    places[wrapped(corner + n)] = {std::abs(middle_m - centre_m), between(middle_m, size_m * double{layouts::kSwayCoarsening})};
  }
  return places;
}

}  // namespace

void Sway::paint_level(std::size_t level) {
  const VirtualBlades& blades = levels_[level].blades;
  const std::size_t count = species_.size(), layers = 4 * count + 1;
  const bool is_last = level + 1 == kLevels;
  // The layer of each of a texel's segments and species, and of its tip; and what each fades into.
  std::vector<glm::vec4*> own(layers);
  std::vector<const glm::vec4*> coarser(layers);
  for (std::size_t l = 0; l < layers; ++l) {
    const bool is_tip = l + 1 == layers;
    own[l] = layer(is_tip ? tip_layer(level) : static_cast<int>(4 * level * count + l)).data();
    if (!is_last) coarser[l] = layer(is_tip ? tip_layer(level + 1) : static_cast<int>(4 * (level + 1) * count + l)).data();
  }
  const auto copy = [&](std::size_t n) {
    glm::vec4 tip(0.0f);
    for (std::size_t s = 0; s < count; ++s) {
      const auto& segments = blades.texels(s)[n].segments;
      for (std::size_t part = 0; part < 4; ++part) own[4 * s + part][n] = segments[part];
      tip += species_[s].share * glm::vec4(segments[0].w, segments[1].w, segments[2].w, 0.0f);
    }
    own[layers - 1][n] = tip;
  };
  std::vector<glm::vec4> means(layers, glm::vec4(0.0f));
  if (is_last) {
    for (std::size_t n = 0; n < kTexels; ++n) {
      copy(n);
      for (std::size_t l = 0; l < layers; ++l) means[l] += own[l][n];
    }
    for (glm::vec4& mean : means) mean /= static_cast<float>(kTexels);
  }

  const double size_m = blades.texel_m(), start_m = fade_start_m(half_m(level)), end_m = fade_end_m(half_m(level));
  const std::array<Place, kSide> columns = places_along(blades.corner().x, size_m, centre_m_.x);
  const std::array<Place, kSide> rows = places_along(blades.corner().y, size_m, centre_m_.y);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, kSide, 8), [&](const auto& range) {
    for (std::size_t row = range.begin(); row != range.end(); ++row) {
      for (std::size_t column = 0; column < kSide; ++column) {
        const std::size_t n = row * kSide + column;
        if (!is_last) copy(n);
        const double distance_m = std::max(columns[column].away_m, rows[row].away_m);
        if (distance_m <= start_m) continue;
        const auto share = static_cast<float>(std::min((distance_m - start_m) / (end_m - start_m), 1.0));
        const TexelBlend beyond = blend_of(columns[column].coarser, rows[row].coarser);
        for (std::size_t l = 0; l < layers; ++l) {
          glm::vec4& texel = own[l][n];
          texel += ((is_last ? means[l] : beyond.of(coarser[l])) - texel) * share;
        }
      }
    }
  });
}

glm::vec4 Sway::sampled(int index, std::size_t level, glm::dvec2 position_m) const {
  const double size_m = texel_m(level);
  return blend_of(between(position_m.x, size_m), between(position_m.y, size_m)).of(&image_[static_cast<std::size_t>(index) * kTexels]);
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
  const double size_m = texel_m(place.level);
  const TexelBlend blend = blend_of(between(place.position_m.x, size_m), between(place.position_m.y, size_m));
  const glm::vec4* texels = &image_[4 * (place.level * species_.size() + species) * kTexels];
  VirtualTexel result;
  for (std::size_t part = 0; part < 4; ++part) result.segments[part] = blend.of(texels + part * kTexels);
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
