#pragma once
namespace prairie {
/// In which representation tiles are drawn; `kAuto` lets each tile's distance decide.
enum class Tier { kAuto, kHermite, kFlat };
}  // namespace prairie
