#include "animation/condition_window.h"

#include <algorithm>
#include <utility>

namespace prairie {
namespace {

constexpr int kSide = layouts::kSwaySide;
constexpr int kNodesPerTexel = 2;
constexpr int kNodeSide = kNodesPerTexel * kSide + 1;

/// The nodes of a window.
NodeBlock nodes_of(std::size_t level, glm::ivec2 corner) {
  return {{kNodesPerTexel * corner.x, kNodesPerTexel * corner.y},
          kNodeSide,
          kNodeSide,
          window_texel_m(level) / kNodesPerTexel};
}

glm::vec4 texel_of(const GrassCondition& condition) {
  return glm::vec4(condition.color_factor, condition.stiffness_factor);
}

GrassCondition condition_of(glm::vec4 texel) {
  return {glm::vec3(texel), texel.w};
}

}  // namespace

ConditionWindow::ConditionWindow(glm::dvec2 eye_m)
    : centre_m_(eye_m), image_(kWindowLevels * kWindowTexels, glm::vec4(1.0f)) {
  for (std::size_t index = 0; index < kWindowLevels; ++index)
    levels_[index] = {window_corner(index, eye_m), {}, std::vector<GrassCondition>(kWindowTexels)};
}

bool ConditionWindow::show(std::span<const Condition> conditions, glm::dvec2 eye_m, double time_s) {
  const std::vector<PresentCondition> present = present_conditions(conditions, time_s);
  bool has_changed = false, is_neutral = true;
  for (std::size_t index = 0; index < kWindowLevels; ++index) {
    Level& level = levels_[index];
    const glm::ivec2 corner = window_corner(index, eye_m);
    const NodeBlock nodes = nodes_of(index, corner);
    std::vector<PresentCondition> covered_by;
    for (const PresentCondition& condition : present) {
      if (!nodes_in_box(nodes, condition.low_m, condition.high_m).is_empty()) covered_by.push_back(condition);
    }
    is_neutral = is_neutral && covered_by.empty();
    const bool is_same = covered_by == level.covered_by && (corner == level.corner || covered_by.empty());
    level.corner = corner;
    if (is_same) continue;
    level.covered_by = std::move(covered_by);
    fill(index, level);
    has_changed = true;
  }
  const bool has_moved = eye_m != centre_m_;
  centre_m_ = eye_m;
  // Where windows fade goes by the eye's place, not by that of texels.
  if (has_changed || (has_moved && !is_neutral)) paint();
  return has_changed;
}

void ConditionWindow::fill(std::size_t index, Level& level) {
  const NodeBlock nodes = nodes_of(index, level.corner);
  std::vector<GrassCondition> values(nodes.size());
  fill_conditions(level.covered_by, nodes, values);
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const GrassCondition* node =
          &values[static_cast<std::size_t>(kNodesPerTexel * (row * kNodeSide + column))];
      const auto across = [](const GrassCondition* west) {
        return 0.25f * texel_of(west[0]) + 0.5f * texel_of(west[1]) + 0.25f * texel_of(west[2]);
      };
      level.texels[window_index(level.corner.x + column, level.corner.y + row)] = condition_of(
          0.25f * across(node) + 0.5f * across(node + kNodeSide) + 0.25f * across(node + 2 * kNodeSide));
    }
  }
}

void ConditionWindow::paint() {
  for (std::size_t index = 0; index < kWindowLevels; ++index) {
    const std::vector<GrassCondition>& texels = levels_[index].texels;
    std::transform(texels.begin(), texels.end(),
                   image_.begin() + static_cast<std::ptrdiff_t>(index * kWindowTexels), texel_of);
  }
  // From the coarsest down: each fades into the one before.
  const glm::vec4* coarser = nullptr;
  for (std::size_t index = kWindowLevels; index-- > 0;) {
    glm::vec4* const torus = &image_[index * kWindowTexels];
    fade_window(index, centre_m_, {&torus, 1}, {&coarser, 1});
    coarser = torus;
  }
  ++revision_;
}

GrassCondition ConditionWindow::at(glm::dvec2 position_m) const {
  const WindowPlace place = window_place(centre_m_, position_m);
  const glm::vec4* torus = &image_[place.level * kWindowTexels];
  return condition_of(window_blend(place.level, place.position_m).of(torus));
}

}  // namespace prairie
