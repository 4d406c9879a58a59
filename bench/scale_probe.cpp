#include "bench/scale_probe.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "bench/scale_plain.h"
#include "render/gl/vertex_layout.h"

namespace prairie {
namespace {

constexpr std::uint32_t kBlades = 60'000;
constexpr std::uint32_t kSegments = 4;
constexpr std::uint32_t kVertices = 2 * kSegments + 1;
constexpr std::uint32_t kTriangles = 2 * kSegments - 1;
constexpr double kEyeM = 1.7;
constexpr double kHeightM = 0.35;
constexpr double kWidthM = 0.0035;
constexpr double kBendM = 0.15;
constexpr double kNearM = 1.0;
constexpr double kFarM = 40.0;
constexpr double kHalfAngleDeg = 40.0;  // as wide as the view

constexpr std::array<VertexAttribute, 1> kVertexAttributes{{{3, GL_FLOAT, 0}}};

/// The fractional parts of multiples of an irrational number: evenly spread in 0…1.
double spread(std::uint32_t n, double irrational) {
  const double multiple = n * irrational;
  return multiple - std::floor(multiple);
}

void append_blade(std::uint32_t n, std::vector<glm::vec3>& vertices) {
  // Thinned by distance as a meadow is: equally many in each ring of equal width.
  const double distance_m = kNearM + (kFarM - kNearM) * spread(n, 0.7548776662466927);
  const double aside = glm::radians(kHalfAngleDeg) * (2.0 * spread(n, 0.5698402909980532) - 1.0);
  const double azimuth = 6.283185307179586 * spread(n, 0.6180339887498949);
  const glm::dvec3 root_m(distance_m * std::sin(aside), distance_m * std::cos(aside), -kEyeM);
  for (std::uint32_t v = 0; v < kVertices; ++v) {
    const double t = static_cast<double>(v / 2) / kSegments;
    const double half_width_m =
        v == kVertices - 1 ? 0.0 : (v % 2 == 0 ? -0.5 : 0.5) * kWidthM * (1.0 - 0.7 * t);
    const double bend_m = kBendM * t * t;
    vertices.emplace_back(root_m + glm::dvec3(bend_m * std::cos(azimuth) + half_width_m,
                                              bend_m * std::sin(azimuth), kHeightM * t));
  }
}

}  // namespace

BladeProbe::BladeProbe()
    : program_(make_plain_program()), vertex_array_(make_vertex_array(kVertexAttributes, "probe")) {
  camera_.pitch_rad = glm::radians(-2.0);
  std::vector<glm::vec3> vertices;
  std::vector<std::uint32_t> indices;
  vertices.reserve(std::size_t{kBlades} * kVertices);
  indices.reserve(std::size_t{kBlades} * kTriangles * 3);
  for (std::uint32_t blade = 0; blade < kBlades; ++blade) {
    append_blade(blade, vertices);
    for (std::uint32_t n = blade * kVertices; n < blade * kVertices + kTriangles; ++n) {
      indices.insert(indices.end(), {n, n + 1, n + 2});
    }
  }
  vertices_.upload(std::span<const glm::vec3>(vertices));
  indices_.upload(std::span<const std::uint32_t>(indices));
  set_vertices(vertex_array_, vertices_, sizeof(glm::vec3));
  glVertexArrayElementBuffer(vertex_array_.get(), indices_.get());
}

double BladeProbe::measure_ms(const OffscreenTarget& target) const {
  Camera camera = camera_;
  camera.size_px = target.size_px();
  const auto start = std::chrono::steady_clock::now();
  begin_plain(program_.get(), target.framebuffer(), camera);
  glBindVertexArray(vertex_array_.get());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(kBlades * kTriangles * 3), GL_UNSIGNED_INT, nullptr);
  glFinish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace prairie
