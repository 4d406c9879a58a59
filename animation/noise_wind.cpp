#include "animation/noise_wind.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "animation/range_check.h"
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

glm::vec2 NoiseTexture::sample(glm::dvec2 at) const {
  constexpr double kTexelsPerCell = static_cast<double>(kSide) / kCells;
  const double x = at.x * kTexelsPerCell, y = at.y * kTexelsPerCell;
  const double column = std::floor(x), row = std::floor(y);
  const float east = static_cast<float>(x - column), north = static_cast<float>(y - row);
  // The side is a power of two: masking wraps, also below zero.
  const auto wrapped = [](std::int64_t n) { return static_cast<std::size_t>(n & (kSide - 1)); };
  const std::size_t i0 = wrapped(static_cast<std::int64_t>(column)),
                    i1 = wrapped(static_cast<std::int64_t>(i0) + 1);
  const std::size_t j0 = kSide * wrapped(static_cast<std::int64_t>(row));
  const std::size_t j1 = kSide * wrapped(static_cast<std::int64_t>(row) + 1);
  const glm::vec2 south = texels[j0 + i0] + (texels[j0 + i1] - texels[j0 + i0]) * east;
  const glm::vec2 norths = texels[j1 + i0] + (texels[j1 + i1] - texels[j1 + i0]) * east;
  return south + (norths - south) * north;
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
  const double speed = glm::length(mean_m_per_s);
  if (speed == 0.0) return glm::vec2(0.0f);
  const glm::dvec2 u = position_m - drift_m;
  glm::vec2 sum(0.0f);
  for (std::size_t n = 0; n < 3; ++n) {
    const glm::dvec2 turn = kTurns[n];
    const glm::dvec2 turned(turn.x * u.x - turn.y * u.y, turn.y * u.x + turn.x * u.y);
    sum += (*textures_)[n].sample(turned / settings_.layers[n].size_m) * settings_.layers[n].strength;
  }
  // x along the wind, y across it.
  const glm::vec2 along(mean_m_per_s / speed);
  const glm::vec2 part = sum * static_cast<float>(speed);
  const float across = part.y * settings_.lateral;
  return {along.x * part.x - along.y * across, along.y * part.x + along.x * across};
}

}  // namespace prairie
