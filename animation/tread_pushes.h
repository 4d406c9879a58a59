// What the bodies of a step do to the nodes of a page, summed before any node is changed: the inner loops of
// treading.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/vec2.hpp>

#include "animation/node_field.h"
#include "animation/tread_node.h"
#include "animation/treading.h"

namespace prairie {

/// A body's step as its nodes need it.
struct TreadPath {
  glm::dvec2 from_m;
  glm::dvec2 low_m, high_m;  // box of what it reaches
  glm::dvec2 to_m;
  glm::vec2 forward;  // unit length
  float length_m;
  float radius_m;
  float reach_m;
  float weight;  // times radius²
  bool stands;
};

TreadPath path_of(const TreadStep& step, double reach_radii, double dt_s);

/// Nodes of a page, first to last of columns and rows.
struct PageBox {
  int first_i = kPageNodes, first_j = kPageNodes, last_i = -1, last_j = -1;
};

/// The nodes of the page that the path may reach; none where first is beyond last.
PageBox reached(const TreadPath& path, PageIndex page, double spacing_m);

/// What a page's bodies do to its nodes (TreadPush), an array for each number so that compilers take several
/// nodes at once.
struct PagePushes {
  using Numbers = std::array<float, kPageNodes * kPageNodes>;
  Numbers field, directed_east, directed_north, held;
  Numbers standing, outward_east, outward_north;  // valid where a body stands
  bool stands;

  /// Rows from `first_j` to `last_j`; numbers of standing bodies only where one stands.
  void clear(int first_j, int last_j, bool one_stands) {
    const auto from = static_cast<std::ptrdiff_t>(first_j * kPageNodes);
    const auto end = static_cast<std::ptrdiff_t>((last_j + 1) * kPageNodes);
    const auto clear_rows = [&](Numbers& numbers) {
      std::fill(numbers.begin() + from, numbers.begin() + end, 0.0f);
    };
    for (Numbers* numbers : {&field, &directed_east, &directed_north, &held}) clear_rows(*numbers);
    stands = one_stands;
    if (!stands) return;
    for (Numbers* numbers : {&standing, &outward_east, &outward_north}) clear_rows(*numbers);
  }

  bool touches(std::size_t slot) const {
    return field[slot] + held[slot] > 0.0f || (stands && standing[slot] > 0.0f);
  }

  TreadPush at(std::size_t slot) const {
    TreadPush push;
    push.field = field[slot];
    push.directed = {directed_east[slot], directed_north[slot]};
    push.held = held[slot] > 0.0f;
    if (stands) {
      push.standing = standing[slot];
      push.outward = {outward_east[slot], outward_north[slot]};
    }
    return push;
  }
};

/// Adds a path's part to the nodes of the page in the box that `reached` gives.
void add_pushes(const TreadPath& path, PageIndex page, const PageBox& box, double spacing_m,
                PagePushes& pushes);

}  // namespace prairie
