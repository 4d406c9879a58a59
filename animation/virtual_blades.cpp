#include "animation/virtual_blades.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "animation/torus.h"
#include "generator/vector_stage.h"

namespace prairie {
namespace {

constexpr std::size_t kBlades = ChainBlock::kBlades;
// Long enough for blades of a metre and little damping, in steps of a frame at 60 Hz.
constexpr int kSettlingSteps = 300;
constexpr float kSettlingStepS = 1.0f / 60.0f;

struct LoadBlock {
  ChainBlock::Row load[12];
  ChainBlock::Row tip[3];
};

PRAIRIE_VECTOR_STAGE void find_loads(const ChainBlock& block, LoadBlock& __restrict found) {
  for (std::size_t n = 0; n < kBlades; ++n) {
    const ChainMotion motion = motion_in(block, n);
    const ChainVectors rest = vectors_in(block.rest, n);
    put_vectors(found.load, n, Kernels{}.virtual_load(rest, motion, traits_in(block, n), wind_in(block, n)));
    const ChainVectors along = Kernels{}.chain_directions(rest, motion.turn);
    const glm::vec3 sum = along.v1 + along.v2 + along.v3 + along.v4;
    found.tip[0][n] = 0.25f * sum.x;
    found.tip[1][n] = 0.25f * sum.y;
    found.tip[2][n] = 0.25f * sum.z - 1.0f;
  }
}

void put_texels(const ChainBlock& block, std::span<VirtualTexel> texels) {
  LoadBlock found;
  find_loads(block, found);
  for (std::size_t n = 0; n < texels.size(); ++n) {
    for (std::size_t s = 0; s < 4; ++s) {
      texels[n].segments[s] = {found.load[3 * s][n], found.load[3 * s + 1][n], found.load[3 * s + 2][n],
                               s < 3 ? found.tip[s][n] : 0.0f};
    }
  }
}

}  // namespace

VirtualBlades::VirtualBlades(std::vector<ChainTraits> species, int side, double texel_m, glm::dvec2 eye_m)
    : side_(side), texel_m_(texel_m), corner_(0) {
  assert(side > 0 && texel_m > 0.0);
  corner_ = corner_around(eye_m, texel_m_, side_);
  const glm::vec3 up(0.0f, 0.0f, 1.0f);
  for (const ChainTraits& traits : species) {
    Stand stand{traits.stiffness, InertialChains(texel_count()), std::vector<VirtualTexel>(texel_count())};
    for (std::size_t n = 0; n < texel_count(); ++n) stand.blades.plant(n, {up, up, up, up}, traits);
    species_.push_back(std::move(stand));
  }
}

glm::ivec2 VirtualBlades::texel_at(std::size_t index) const {
  const int column = static_cast<int>(index % static_cast<std::size_t>(side_));
  const int row = static_cast<int>(index / static_cast<std::size_t>(side_));
  return {corner_.x + wrapped(column - corner_.x, side_), corner_.y + wrapped(row - corner_.y, side_)};
}

glm::dvec2 VirtualBlades::middle_m(std::size_t index) const {
  const glm::ivec2 texel = texel_at(index);
  return {(texel.x + 0.5) * texel_m_, (texel.y + 0.5) * texel_m_};
}

void VirtualBlades::follow(glm::dvec2 eye_m) {
  const glm::ivec2 old = corner_, now = corner_around(eye_m, texel_m_, side_);
  if (now == old) return;
  corner_ = now;
  // What both windows hold.
  const glm::ivec2 low(std::max(old.x, now.x), std::max(old.y, now.y));
  const glm::ivec2 high(std::min(old.x, now.x) + side_ - 1, std::min(old.y, now.y) + side_ - 1);
  const bool overlap = low.x <= high.x && low.y <= high.y;
  for (std::size_t n = 0; n < texel_count(); ++n) {
    const glm::ivec2 texel = texel_at(n);
    const bool stays =
        overlap && texel.x >= low.x && texel.x <= high.x && texel.y >= low.y && texel.y <= high.y;
    if (stays) continue;
    const std::size_t nearest =
        overlap ? torus_index(std::clamp(texel.x, low.x, high.x), std::clamp(texel.y, low.y, high.y), side_)
                : n;
    for (Stand& stand : species_) {
      stand.blades.set_motion(n, overlap ? stand.blades.motion(nearest) : ChainMotion{});
      stand.texels[n] = overlap ? stand.texels[nearest] : VirtualTexel{};
    }
  }
}

void VirtualBlades::stiffen(std::size_t index, float factor) {
  for (Stand& stand : species_) stand.blades.set_stiffness(index, factor * stand.stiffness);
}

template <class Move>
void VirtualBlades::for_blocks(std::span<const glm::vec3> wind_m_per_s, Move move) {
  assert(wind_m_per_s.size() == texel_count());
  constexpr std::size_t kTogether = 16;
  for (Stand& stand : species_) {
    const std::span<VirtualTexel> texels(stand.texels);
    const std::size_t count = stand.blades.blocks().size();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kTogether), [&](const auto& range) {
      const std::size_t first = range.begin() * kBlades, end = std::min(range.end() * kBlades, texels.size());
      for (std::size_t n = first; n < end; ++n) stand.blades.set_wind(n, wind_m_per_s[n]);
      move(stand.blades, range.begin(), range.end());
      for (std::size_t b = range.begin(); b < range.end(); ++b) {
        const std::size_t from = b * kBlades;
        put_texels(stand.blades.blocks()[b], texels.subspan(from, std::min(kBlades, texels.size() - from)));
      }
    });
  }
}

void VirtualBlades::feel(std::span<const glm::vec3> wind_m_per_s) {
  for_blocks(wind_m_per_s, [](InertialChains&, std::size_t, std::size_t) {});
}

void VirtualBlades::step(std::span<const glm::vec3> wind_m_per_s, float dt_s) {
  for_blocks(wind_m_per_s, [dt_s](InertialChains& blades, std::size_t first, std::size_t end) {
    blades.step_blocks(first, end, dt_s);
  });
}

void VirtualBlades::settle(std::span<const glm::vec3> wind_m_per_s) {
  for (int n = 0; n < kSettlingSteps; ++n) step(wind_m_per_s, kSettlingStepS);
}

VirtualTexel VirtualBlades::at(std::size_t species, glm::dvec2 position_m) const {
  const double x = position_m.x / texel_m_ - 0.5, y = position_m.y / texel_m_ - 0.5;
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  const float u = static_cast<float>(x - i), v = static_cast<float>(y - j);
  const std::vector<VirtualTexel>& texels = species_[species].texels;
  VirtualTexel result;
  for (std::size_t s = 0; s < 4; ++s) {
    const auto texel = [&](int di, int dj) { return texels[torus_index(i + di, j + dj, side_)].segments[s]; };
    const glm::vec4 south = texel(0, 0) + (texel(1, 0) - texel(0, 0)) * u;
    const glm::vec4 north = texel(0, 1) + (texel(1, 1) - texel(0, 1)) * u;
    result.segments[s] = south + (north - south) * v;
  }
  return result;
}

}  // namespace prairie
