// The turbulence of the wind (B11 §3.2), which the mean wind W0 carries along:
//
//   W[u] = W0 + Σ k_i T_i[w_i t + c_i R_i u]        i = 1, 2, 3
//
// T_i: cyclic noise textures of unit variance (shaders/kernels/wind_noise.glsl), c_i = 1/size, w_i t = −c_i
// R_i ∫ W0 dt, so that gusts travel with the wind, also with one that changes; k_i = strength |W0|.
// Deviations: each T is a texture of its own and holds both components, k_i in proportion to the mean speed,
// as turbulence is; R_i are fixed angles that do not follow the wind, since turning W0 would sweep distant
// places through the texture.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

namespace prairie {

struct WindLayer {
  double size_m;   // of a cell of the texture's coarser octave, 0.5…5000
  float strength;  // standard deviation along the wind by mean speed, 0…2
};

struct NoiseWindSettings {
  // Chosen for the wind at 4.4 m over low vegetation: intensity 0.215, gusts of 3 s, integral length about
  // 120 m.
  std::array<WindLayer, 3> layers = {{{450.0, 0.185f}, {60.0, 0.115f}, {11.0, 0.065f}}};
  float lateral = 0.87f;  // across the wind by along it, 0…2
  std::uint32_t seed = 1;
};

/// One cyclic texture; rows from south.
struct NoiseTexture {
  static constexpr int kSide = 256;
  static constexpr int kCells = 16;  // of the coarser octave
  std::vector<glm::vec2> texels;     // mean 0 and variance 1, each component

  /// Bilinear; `at` in cells, any number.
  glm::vec2 sample(glm::dvec2 at) const;
};

NoiseTexture make_noise_texture(std::uint32_t seed);

class NoiseWind {
 public:
  /// Throws BadInput on settings out of range.
  explicit NoiseWind(const NoiseWindSettings& settings);

  const NoiseWindSettings& settings() const { return settings_; }
  const std::array<NoiseTexture, 3>& textures() const { return *textures_; }

  /// What turbulence adds to a mean wind that has blown `drift_m`, m/s.
  glm::vec2 velocity_m_per_s(glm::dvec2 position_m, glm::dvec2 mean_m_per_s, glm::dvec2 drift_m) const;

  /// Adds the same to a row of places eastward from `first_m`, as many as there are means.
  void add_row(glm::dvec2 first_m, double spacing_m, std::span<const glm::dvec2> means_m_per_s,
               glm::dvec2 drift_m, std::span<glm::vec2> row_m_per_s) const;

 private:
  NoiseWindSettings settings_;
  std::shared_ptr<const std::array<NoiseTexture, 3>> textures_;  // never changes; copies share it
};

}  // namespace prairie
