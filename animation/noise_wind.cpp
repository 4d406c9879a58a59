#include "animation/noise_wind.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "animation/range_check.h"
#include "generator/vector_stage.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

// Angles of R_i as directions (cos, sin) of slopes that are no simple fractions: a straight wind then passes
// over all of a cyclic texture before it comes close to where it began.
constexpr std::array<glm::dvec2, 3> kTurns = {glm::dvec2(0.8506508083520400, 0.5257311121191336),
                                              glm::dvec2(0.3826834323650898, 0.9238795325112867),
                                              glm::dvec2(-0.5773502691896258, 0.8164965809277260)};

void check(const std::string& field, double value, double low, double high) {
  check_range("wind: " + field, value, low, high);
}

NoiseWindSettings checked(const NoiseWindSettings& settings) {
  for (std::size_t n = 0; n < settings.layers.size(); ++n) {
    check(fmt::format("layer {}: size_m", n + 1), settings.layers[n].size_m, 0.5, 5000.0);
    check(fmt::format("layer {}: strength", n + 1), static_cast<double>(settings.layers[n].strength), 0.0,
          2.0);
  }
  check("lateral", static_cast<double>(settings.lateral), 0.0, 2.0);
  return settings;
}

}  // namespace

NoiseTexture make_noise_texture(std::uint32_t seed) {
  constexpr int kSide = NoiseTexture::kSide;
  NoiseTexture texture;
  texture.texels.resize(static_cast<std::size_t>(kSide) * kSide);
  constexpr float kCellsPerTexel = static_cast<float>(NoiseTexture::kCells) / kSide;
  oneapi::tbb::parallel_for(0, kSide, [&](int row) {
    Kernels kernels;
    for (int column = 0; column < kSide; ++column) {
      const glm::vec2 at(static_cast<float>(column) * kCellsPerTexel,
                         static_cast<float>(row) * kCellsPerTexel);
      texture.texels[static_cast<std::size_t>(row * kSide + column)] =
          kernels.wind_noise(at, NoiseTexture::kCells, seed);
    }
  });
  glm::dvec2 sum(0.0), squares(0.0);
  for (const glm::vec2& texel : texture.texels) {
    sum += glm::dvec2(texel);
    squares += glm::dvec2(texel) * glm::dvec2(texel);
  }
  const double count = static_cast<double>(texture.texels.size());
  const glm::dvec2 mean = sum / count;
  const glm::dvec2 variance = squares / count - mean * mean;
  const glm::dvec2 scale(1.0 / std::sqrt(variance.x), 1.0 / std::sqrt(variance.y));
  for (glm::vec2& texel : texture.texels) texel = glm::vec2((glm::dvec2(texel) - mean) * scale);
  return texture;
}

namespace {

// Where a place lies in a texture: its texel's column and row, and how far on to the next. Without branches
// and calls, so that it takes part in a vector stage.
struct TexelPlace {
  int column, row;
  float east, north;
};

inline TexelPlace texel_place(glm::dvec2 at) {
  constexpr int kSide = NoiseTexture::kSide;
  constexpr double kTexelsPerCell = static_cast<double>(kSide) / NoiseTexture::kCells;
  const double x = at.x * kTexelsPerCell, y = at.y * kTexelsPerCell;
  const double column = std::floor(x), row = std::floor(y);
  // The side is a power of two: masking wraps what rounding left at the side itself.
  const auto wrapped = [](double n) {
    return static_cast<int>(n - kSide * std::floor(n * (1.0 / kSide))) & (kSide - 1);
  };
  return {wrapped(column), wrapped(row), static_cast<float>(x - column), static_cast<float>(y - row)};
}

/// One component of the texture there; `values`: that of the first texel.
inline float blended(const float* values, int column, int row, float east, float north) {
  constexpr int kSide = NoiseTexture::kSide;
  const int i0 = 2 * column, i1 = 2 * ((column + 1) & (kSide - 1));
  const int j0 = 2 * kSide * row, j1 = 2 * kSide * ((row + 1) & (kSide - 1));
  const float south = values[j0 + i0] + (values[j0 + i1] - values[j0 + i0]) * east;
  const float norths = values[j1 + i0] + (values[j1 + i1] - values[j1 + i0]) * east;
  return south + (norths - south) * north;
}

inline glm::dvec2 layer_place(glm::dvec2 from_drift_m, glm::dvec2 turn, double size_m) {
  return glm::dvec2(turn.x * from_drift_m.x - turn.y * from_drift_m.y,
                    turn.y * from_drift_m.x + turn.x * from_drift_m.y) /
         size_m;
}

/// The sum of the layers, which is 1 where the wind changes by its own speed, in the wind's directions.
inline glm::vec2 gusts_m_per_s(glm::vec2 sum, glm::dvec2 mean_m_per_s, float lateral) {
  const double speed = std::sqrt(mean_m_per_s.x * mean_m_per_s.x + mean_m_per_s.y * mean_m_per_s.y);
  // x along the wind, y across it.
  const glm::vec2 along(mean_m_per_s / (speed > 0.0 ? speed : 1.0));
  const glm::vec2 part = sum * static_cast<float>(speed);
  const float across = part.y * lateral;
  return {along.x * part.x - along.y * across, along.y * part.x + along.x * across};
}

constexpr int kTogether = 16;

/// A run of places as the processor likes them.
struct PlaceBlock {
  int column[kTogether], row[kTogether];
  float east[kTogether], north[kTogether];
  float x[kTogether], y[kTogether];  // sum of the layers
};

/// Adds a layer to the places of a row from its `first`-th on.
PRAIRIE_VECTOR_STAGE void add_layer(const NoiseTexture& texture, const WindLayer& layer, glm::dvec2 turn,
                                    glm::dvec2 row_m, double spacing_m, int first, glm::dvec2 drift_m,
                                    PlaceBlock& __restrict block) {
  const float* values = &texture.texels.data()->x;
  const double size_m = layer.size_m;
  const float strength = layer.strength;
  for (int n = 0; n < kTogether; ++n) {
    const TexelPlace place =
        texel_place(layer_place(row_m + glm::dvec2((first + n) * spacing_m, 0.0) - drift_m, turn, size_m));
    block.column[n] = place.column;
    block.row[n] = place.row;
    block.east[n] = place.east;
    block.north[n] = place.north;
  }
  for (int n = 0; n < kTogether; ++n)
    block.x[n] += blended(values, block.column[n], block.row[n], block.east[n], block.north[n]) * strength;
  for (int n = 0; n < kTogether; ++n)
    block.y[n] +=
        blended(values + 1, block.column[n], block.row[n], block.east[n], block.north[n]) * strength;
}

}  // namespace

glm::vec2 NoiseTexture::sample(glm::dvec2 at) const {
  const TexelPlace place = texel_place(at);
  const float* values = &texels.data()->x;
  return {blended(values, place.column, place.row, place.east, place.north),
          blended(values + 1, place.column, place.row, place.east, place.north)};
}

NoiseWind::NoiseWind(const NoiseWindSettings& settings) : settings_(checked(settings)) {
  auto textures = std::make_shared<std::array<NoiseTexture, 3>>();
  for (std::uint32_t n = 0; n < 3; ++n) {
    (*textures)[n] = make_noise_texture(Kernels{}.hash_uvec3(glm::uvec3(settings.seed, n, 0x57494e44u)).x);
  }
  textures_ = std::move(textures);
}

glm::vec2 NoiseWind::velocity_m_per_s(glm::dvec2 position_m, glm::dvec2 mean_m_per_s,
                                      glm::dvec2 drift_m) const {
  glm::vec2 sum(0.0f);
  for (std::size_t n = 0; n < 3; ++n) {
    const WindLayer& layer = settings_.layers[n];
    sum +=
        (*textures_)[n].sample(layer_place(position_m - drift_m, kTurns[n], layer.size_m)) * layer.strength;
  }
  return gusts_m_per_s(sum, mean_m_per_s, settings_.lateral);
}

void NoiseWind::add_row(glm::dvec2 first_m, double spacing_m, std::span<const glm::dvec2> means_m_per_s,
                        glm::dvec2 drift_m, std::span<glm::vec2> row_m_per_s) const {
  for (std::size_t first = 0; first < row_m_per_s.size(); first += kTogether) {
    PlaceBlock block{};
    for (std::size_t n = 0; n < 3; ++n)
      add_layer((*textures_)[n], settings_.layers[n], kTurns[n], first_m, spacing_m, static_cast<int>(first),
                drift_m, block);
    const std::size_t end = std::min(first + kTogether, row_m_per_s.size());
    for (std::size_t n = first; n < end; ++n)
      row_m_per_s[n] +=
          gusts_m_per_s({block.x[n - first], block.y[n - first]}, means_m_per_s[n], settings_.lateral);
  }
}

}  // namespace prairie
