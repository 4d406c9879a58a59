#include "maps/map_warnings.h"

#include <fmt/format.h>

#include <cmath>

#include "files/error.h"

namespace prairie {
namespace {

constexpr double kWorthAWarning = 0.01;  // share of the nodes

/// Heights by which a map goes in stairs, as those of 8 bits do.
constexpr double kSteepStep = 0.1;            // of the distance of two nodes
constexpr double kLeastNodesOfALevel = 16.0;  // on average: fewer are ground that happens to be level
/// Beyond the others by more than they differ among themselves.
constexpr float kLeastGap_m = 20.0f;

class Warnings {
 public:
  explicit Warnings(const MapSpec& spec) : spec_(spec) {}
  void add(const char* code, const std::string& text) {
    if (!text.empty())
      warnings_.push_back({code, fmt::format("{}: {}: {}", spec_.file.string(), spec_.field, text)});
  }
  std::vector<Warning> release() { return std::move(warnings_); }

 private:
  const MapSpec& spec_;
  std::vector<Warning> warnings_;
};

/// One value, far from all others, as a forgotten nodata value is.
std::string lone_value(const ValueCensus& census, double gap_share) {
  const Extreme &low = census.lowest, &high = census.highest;
  const float below = low.next - low.value, above = high.value - high.next;
  const float rest_below = high.value - low.next, rest_above = high.next - low.value;
  const bool is_low = below > kLeastGap_m && below > rest_below;
  const bool is_high = above > kLeastGap_m && above > rest_above;
  if (gap_share >= 1.0 || (!is_low && !is_high)) return "";
  const Extreme& lone = is_low ? low : high;
  return fmt::format(
      "{:.2g} % of the nodes hold {:.6g} m, {:.0f} m {} all others; if that means no data, say so: `nodata = "
      "{:.6g}`",
      100.0 * static_cast<double>(lone.count) / static_cast<double>(census.nodes), lone.value,
      is_low ? below : above, is_low ? "below" : "above", lone.stored);
}

std::string stairs(const ValueCensus& census, double spacing_m) {
  if (!census.levels.is_complete() || census.levels.count() < 2) return "";
  const double step_m =
      static_cast<double>(census.max - census.min) / static_cast<double>(census.levels.count() - 1);
  const bool is_steep = step_m > kSteepStep * spacing_m;
  const bool is_levelled = static_cast<double>(census.nodes - census.gaps) >
                           kLeastNodesOfALevel * static_cast<double>(census.levels.count());
  if (!is_steep || !is_levelled) return "";
  return fmt::format(
      "only {} different heights, in steps of {:.2g} m on nodes {:.3g} m apart: slopes are stairs; a file of "
      "16 bits or "
      "of floating-point numbers has none",
      census.levels.count(), step_m, spacing_m);
}

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

std::vector<Warning> map_warnings(const MapSpec& spec, MapMeaning meaning, const ValueCensus& census,
                                  double spacing_m) {
  Warnings warnings(spec);
  const double nodes = static_cast<double>(census.nodes);
  const double gap_share = static_cast<double>(census.gaps) / nodes;
  const double outside_share = static_cast<double>(census.out_of_range) / nodes;
  if (gap_share > kWorthAWarning)
    warnings.add("no-data", fmt::format("{:.1f} % of the nodes have no data", 100.0 * gap_share));
  if (outside_share > kWorthAWarning) {
    warnings.add("clamped",
                 fmt::format("{:.1f} % of the values lie outside the range and are clamped: the file's "
                             "values run from {:.6g} to {:.6g}",
                             100.0 * outside_share, census.least_quantity, census.most_quantity));
  }
  if (census.min == census.max) {
    if (meaning == MapMeaning::kDensity && census.max == 0.0f) {
      warnings.add("nothing-grows", "the density is zero everywhere: nothing grows");
    } else {
      warnings.add("one-value", fmt::format("every node has the same value, {}", census.max));
    }
  } else if (meaning == MapMeaning::kHeight) {
    warnings.add("lone-value", lone_value(census, gap_share));
    warnings.add("stairs", stairs(census, spacing_m));
  }
  return warnings.release();
}

Warning map_note(const MapSpec& spec, const char* code, const std::string& text) {
  return {code, fmt::format("{}: {}: {}", spec.file.string(), spec.field, text)};
}

}  // namespace prairie
