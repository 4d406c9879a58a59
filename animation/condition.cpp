#include "animation/condition.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "animation/range_check.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

float ramp(double x) {
  return Kernels{}.smooth_ramp(static_cast<float>(x));
}

// Of 0.1 to 10, by square roots and a short series, which are the same everywhere: ln x = 16 ln ¹⁶√x, and
// ln y = 2 artanh((y − 1)/(y + 1)). Error below 2e-10.
double natural_log(double x) {
  double y = x;
  for (int n = 0; n < 4; ++n) y = std::sqrt(y);
  const double z = (y - 1.0) / (y + 1.0), z2 = z * z;
  return 32.0 * z * (1.0 + z2 * (1.0 / 3.0 + z2 * (1.0 / 5.0 + z2 / 7.0)));
}

float exponential(float x) {
  Kernels kernels;
  return x > 0.0f ? 1.0f / kernels.falling_exponential(x) : kernels.falling_exponential(-x);
}

/// The sums of the header's formulas.
struct Sum {
  float weight = 0.0f;
  glm::vec3 color_change{0.0f};
  float log_stiffness = 0.0f;

  void add(const PresentCondition& condition, float of_it) {
    weight += of_it;
    color_change += of_it * condition.color_change;
    log_stiffness += of_it * condition.log_stiffness;
  }
  GrassCondition mean() const {
    const float share = 1.0f / std::max(weight, 1.0f);
    return {1.0f + share * color_change, exponential(share * log_stiffness)};
  }
};

}  // namespace

void check(const Condition& condition, const std::string& name) {
  const auto number = [&](const char* field, double value, double low, double high) {
    check_range(name + ": " + field, value, low, high);
  };
  const auto pair = [&](const char* field, glm::dvec2 value, double most) {
    number(field, value.x, -most, most);
    number(field, value.y, -most, most);
  };
  pair("centre_m", condition.centre_m, 1e7);
  pair("velocity_m_per_s", condition.velocity_m_per_s, 100.0);
  number("radius_m", condition.radius_m, 0.01, 1e5);
  number("edge_m", condition.edge_m, 0.01, condition.radius_m);
  number("start_s", condition.start_s, -1e9, 1e9);
  number("duration_s", condition.duration_s, 0.0, 1e9);
  number("fade_s", condition.fade_s, 0.0, 1e9);
  for (int c = 0; c < 3; ++c)
    number("color_factor", static_cast<double>(condition.color_factor[c]), 0.0, 4.0);
  number("stiffness_factor", condition.stiffness_factor, 0.1, 10.0);
}

double end_s(const Condition& condition) {
  return condition.duration_s > 0.0 ? condition.start_s + condition.duration_s
                                    : std::numeric_limits<double>::infinity();
}

std::optional<PresentCondition> present_condition(const Condition& condition, double time_s) {
  const double age_s = time_s - condition.start_s, left_s = end_s(condition) - time_s;
  if (age_s < 0.0 || left_s <= 0.0) return std::nullopt;
  const bool lasts = condition.duration_s == 0.0;
  const double fade_s = lasts ? condition.fade_s : std::min(condition.fade_s, 0.5 * condition.duration_s);
  float strength = 1.0f;
  if (fade_s > 0.0) strength = ramp(age_s / fade_s) * (lasts ? 1.0f : ramp(left_s / fade_s));
  if (strength <= 0.0f) return std::nullopt;
  const glm::dvec2 centre_m = condition.centre_m + age_s * condition.velocity_m_per_s;
  return PresentCondition{centre_m,
                          condition.radius_m,
                          condition.edge_m,
                          strength,
                          condition.color_factor - 1.0f,
                          static_cast<float>(natural_log(condition.stiffness_factor)),
                          centre_m - condition.radius_m,
                          centre_m + condition.radius_m};
}

std::vector<PresentCondition> present_conditions(std::span<const Condition> conditions, double time_s) {
  std::vector<PresentCondition> present;
  for (const Condition& condition : conditions) {
    if (const auto now = present_condition(condition, time_s)) present.push_back(*now);
  }
  return present;
}

float weight_at(const PresentCondition& condition, glm::dvec2 position_m) {
  const double inside_m = condition.radius_m - glm::length(position_m - condition.centre_m);
  return inside_m > 0.0 ? condition.strength * ramp(inside_m / condition.edge_m) : 0.0f;
}

GrassCondition grass_condition(std::span<const PresentCondition> conditions, glm::dvec2 position_m) {
  Sum sum;
  for (const PresentCondition& condition : conditions) sum.add(condition, weight_at(condition, position_m));
  return sum.mean();
}

std::size_t fill_conditions(std::span<const PresentCondition> conditions, const NodeBlock& nodes,
                            std::span<GrassCondition> out) {
  assert(out.size() == nodes.size());
  std::fill(out.begin(), out.end(), GrassCondition{});
  struct Part {
    const PresentCondition* condition;
    NodeRange range;
  };
  std::vector<Part> parts;
  std::size_t evaluated = 0;
  for (const PresentCondition& condition : conditions) {
    const NodeRange range = nodes_in_box(nodes, condition.low_m, condition.high_m);
    if (range.is_empty()) continue;
    parts.push_back({&condition, range});
    evaluated += range.size();
  }
  if (parts.empty()) return 0;

  const glm::dvec2 low_m = nodes.low_m();
  const auto fill_row = [&](int row, std::vector<Sum>& sums) {
    int first = nodes.columns, last = -1;
    for (const auto& [condition, range] : parts) {
      if (row < range.first_row || row > range.last_row) continue;
      first = std::min(first, range.first_column);
      last = std::max(last, range.last_column);
      for (int column = range.first_column; column <= range.last_column; ++column) {
        const glm::dvec2 position_m = low_m + glm::dvec2(column, row) * nodes.spacing_m;
        sums[static_cast<std::size_t>(column)].add(*condition, weight_at(*condition, position_m));
      }
    }
    GrassCondition* out_row = &out[static_cast<std::size_t>(row) * static_cast<std::size_t>(nodes.columns)];
    for (int column = first; column <= last; ++column) {
      Sum& sum = sums[static_cast<std::size_t>(column)];
      out_row[column] = sum.mean();
      sum = Sum{};
    }
  };
  oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, nodes.rows, 8), [&](const auto& range) {
    std::vector<Sum> sums(static_cast<std::size_t>(nodes.columns));
    for (int row = range.begin(); row != range.end(); ++row) fill_row(row, sums);
  });
  return evaluated;
}

}  // namespace prairie
