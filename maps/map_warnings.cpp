#include "maps/map_warnings.h"

#include <fmt/format.h>

#include <cmath>

#include "files/error.h"

namespace prairie {
namespace {

constexpr double kWorthAWarning = 0.01;  // share of the nodes

}  // namespace

void check_census(const MapSpec& spec, MapMeaning meaning, const ValueCensus& census) {
  if (census.gaps == census.nodes)
    throw BadInput(spec.file.string(), spec.field, "no pixel with data", "at least one");
  if (meaning != MapMeaning::kHeight) return;
  for (const float height_m : {census.min, census.max}) {
    if (std::abs(height_m) <= kMaxHeight_m) continue;
    throw BadInput(
        spec.file.string(), spec.field, fmt::format("a height of {} m", height_m),
        fmt::format("heights within ±{:.0f} m, or `nodata` naming the value that means none", kMaxHeight_m));
  }
}

std::vector<std::string> map_warnings(const MapSpec& spec, MapMeaning meaning, const ValueCensus& census,
                                      const std::vector<std::string>& notes) {
  std::vector<std::string> warnings;
  const auto warn = [&](const std::string& text) {
    warnings.push_back(fmt::format("{}: {}: {}", spec.file.string(), spec.field, text));
  };
  const double nodes = static_cast<double>(census.nodes);
  const double gap_share = static_cast<double>(census.gaps) / nodes;
  const double outside_share = static_cast<double>(census.out_of_range) / nodes;
  if (gap_share > kWorthAWarning) warn(fmt::format("{:.1f} % of the nodes have no data", 100.0 * gap_share));
  if (outside_share > kWorthAWarning)
    warn(fmt::format("{:.1f} % of the values lie outside the range and are clamped", 100.0 * outside_share));
  if (census.min == census.max) {
    const bool nothing_grows = meaning == MapMeaning::kDensity && census.max == 0.0f;
    warn(nothing_grows ? "the density is zero everywhere: nothing grows"
                       : fmt::format("every node has the same value, {}", census.max));
  }
  for (const std::string& note : notes) {
    if (!note.empty()) warn(note);
  }
  return warnings;
}

}  // namespace prairie
