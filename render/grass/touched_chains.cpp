#include "render/grass/touched_chains.h"

#include <algorithm>

namespace prairie {
namespace {

constexpr std::size_t kWords = 36;  // nine texels

void append(const Kernels::BladeChain& chain, std::vector<float>& out) {
  const std::size_t first = out.size();
  for (const glm::vec3& v : {chain.p0, chain.p1, chain.p2, chain.p3, chain.p4, chain.m0, chain.m1, chain.m2,
                             chain.m3, chain.m4, chain.side})
    out.insert(out.end(), {v.x, v.y, v.z});
  out.resize(first + kWords, 0.0f);
}

}  // namespace

TouchedChains::TouchedChains() = default;

void TouchedChains::set(StreamBuffer& stream, const TouchedBlades& blades) {
  first_slots_.clear();
  slots_.clear();
  chains_.clear();
  chains_.reserve(kWords * blades.chains().size());
  for (const TouchedGroup& group : blades.groups()) {
    if (std::all_of(group.slots.begin(), group.slots.end(), [](std::uint32_t slot) { return slot == 0; }))
      continue;
    first_slots_[packed(group.key)] = static_cast<std::uint32_t>(slots_.size());
    slots_.insert(slots_.end(), group.slots.begin(), group.slots.end());
  }
  for (const Kernels::BladeChain& chain : blades.chains()) append(chain, chains_);
  slot_view_.show(stream, std::span<const std::uint32_t>(slots_));
  chain_view_.show(stream, std::span<const float>(chains_));
}

void TouchedChains::show(StreamBuffer& stream, std::span<const DrawnCell> run) {
  run_cells_.clear();
  for (const DrawnCell& cell : run) {
    const auto found = first_slots_.find(packed(cell.planted.key));
    run_cells_.push_back(found == first_slots_.end() ? 0 : found->second + 1);
  }
  cell_view_.show(stream, std::span<const std::uint32_t>(run_cells_));
  cell_view_.bind(layouts::kTouchedCellUnit);
  slot_view_.bind(layouts::kTouchedSlotUnit);
  chain_view_.bind(layouts::kTouchedChainUnit);
}

}  // namespace prairie
