#include "animation/noise_wind.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

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

// Without branches and calls, so that a row of places is one vector stage.
inline glm::vec2 sampled(const glm::vec2* texels, glm::dvec2 at) {
  constexpr int kSide = NoiseTexture::kSide;
  constexpr double kTexelsPerCell = static_cast<double>(kSide) / NoiseTexture::kCells;
  const double x = at.x * kTexelsPerCell, y = at.y * kTexelsPerCell;
  const double column = std::floor(x), row = std::floor(y);
  const float east = static_cast<float>(x - column), north = static_cast<float>(y - row);
  // The side is a power of two: masking wraps what rounding left at the side itself.
  const auto wrapped = [](double n) { return static_cast<int>(n - kSide * std::floor(n * (1.0 / kSide))) & (kSide - 1); };
  const int i0 = wrapped(column), i1 = (i0 + 1) & (kSide - 1);
  const int j0 = kSide * wrapped(row), j1 = (j0 + kSide) & (kSide * kSide - 1);
  const glm::vec2 south = texels[j0 + i0] + (texels[j0 + i1] - texels[j0 + i0]) * east;
  const glm::vec2 norths = texels[j1 + i0] + (texels[j1 + i1] - texels[j1 + i0]) * east;
  return south + (norths - south) * north;
}

inline glm::vec2 turbulence(const std::array<NoiseTexture, 3>& textures, const NoiseWindSettings& settings, glm::dvec2 position_m,
                            glm::dvec2 mean_m_per_s, glm::dvec2 drift_m) {
  const double speed = std::sqrt(mean_m_per_s.x * mean_m_per_s.x + mean_m_per_s.y * mean_m_per_s.y);
  const glm::dvec2 u = position_m - drift_m;
  glm::vec2 sum(0.0f);
  for (std::size_t n = 0; n < 3; ++n) {
    const glm::dvec2 turn = kTurns[n];
    const glm::dvec2 turned(turn.x * u.x - turn.y * u.y, turn.y * u.x + turn.x * u.y);
    sum += sampled(textures[n].texels.data(), turned / settings.layers[n].size_m) * settings.layers[n].strength;
  }
  // x along the wind, y across it.
  const glm::vec2 along(mean_m_per_s / (speed > 0.0 ? speed : 1.0));
  const glm::vec2 part = sum * static_cast<float>(speed);
  const float across = part.y * settings.lateral;
  return {along.x * part.x - along.y * across, along.y * part.x + along.x * across};
}

}  // namespace

glm::vec2 NoiseTexture::sample(glm::dvec2 at) const { return sampled(texels.data(), at); }

NoiseWind::NoiseWind(const NoiseWindSettings& settings) : settings_(checked(settings)) {
  auto textures = std::make_shared<std::array<NoiseTexture, 3>>();
  for (std::uint32_t n = 0; n < 3; ++n) {
    (*textures)[n] = make_noise_texture(Kernels{}.hash_uvec3(glm::uvec3(settings.seed, n, 0x57494e44u)).x);
  }
  textures_ = std::move(textures);
}

glm::vec2 NoiseWind::velocity_m_per_s(glm::dvec2 position_m, glm::dvec2 mean_m_per_s, glm::dvec2 drift_m) const {
  return turbulence(*textures_, settings_, position_m, mean_m_per_s, drift_m);
}

PRAIRIE_VECTOR_STAGE void NoiseWind::add_row(glm::dvec2 first_m, double spacing_m, std::span<const glm::dvec2> means_m_per_s,
                                             glm::dvec2 drift_m, std::span<glm::vec2> row_m_per_s) const {
  const std::array<NoiseTexture, 3>& textures = *textures_;
  const NoiseWindSettings settings = settings_;
  const glm::dvec2* means = means_m_per_s.data();
  glm::vec2* __restrict row = row_m_per_s.data();
  for (int n = 0; n < static_cast<int>(row_m_per_s.size()); ++n)
    row[n] += turbulence(textures, settings, first_m + glm::dvec2(n * spacing_m, 0.0), means[n], drift_m);
}

}  // namespace prairie
