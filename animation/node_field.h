// A field of nodes that moves (G03 §4.1): unbounded, and sparse, for most of a meadow is at rest. Nodes lie
// in square pages; a page is made when one of its nodes is first touched and may be freed once all of them
// are at rest, so that memory follows the area touched and nodes that nothing covers cost nothing.
//
// Node (i, j) lies at (i, j) · spacing_m in the scene (metres; x east, y north). A node at rest equals
// Node{}. Everything iterates in the order of pages, from south to north and from west to east in a row,
// whatever the order in which they were touched.
#pragma once

#include <array>
#include <cassert>
#include <compare>
#include <cstddef>
#include <glm/vec2.hpp>
#include <map>
#include <utility>

namespace prairie {

/// Nodes along a side of a page.
inline constexpr int kPageNodes = 16;

struct NodeIndex {
  int i = 0;  // east
  int j = 0;  // north

  bool operator==(const NodeIndex&) const = default;
};

/// Holds the nodes from kPageNodes · (i, j) on.
struct PageIndex {
  int j = 0;  // north; first, so that order is by rows
  int i = 0;  // east

  auto operator<=>(const PageIndex&) const = default;

  NodeIndex south_west() const { return {i * kPageNodes, j * kPageNodes}; }
};

/// The page of a node, and where the node lies in it (row by row from south-west).
PageIndex page_of(NodeIndex node);
std::size_t slot_of(NodeIndex node);

/// The square of nodes that a position lies in, and where in the square.
struct NodeSquare {
  NodeIndex south_west;
  float east = 0.0f;   // 0…1
  float north = 0.0f;  // 0…1
};
NodeSquare square_of(glm::dvec2 position_m, double spacing_m);

template <class Node>
class NodeField {
 public:
  using Page = std::array<Node, kPageNodes * kPageNodes>;

  explicit NodeField(double spacing_m) : spacing_m_(spacing_m) { assert(spacing_m > 0.0); }

  double spacing_m() const { return spacing_m_; }

  /// In the order of pages. Pages keep their place in memory until they are freed.
  const std::map<PageIndex, Page>& pages() const { return pages_; }

  /// The page, made if there is none. Not thread-safe; different pages may then be written at the same time.
  Page& touch_page(PageIndex page) { return pages_[page]; }

  /// Null where all nodes are at rest.
  const Page* find_page(PageIndex page) const {
    const auto found = pages_.find(page);
    return found == pages_.end() ? nullptr : &found->second;
  }

  Page* find_page(PageIndex page) { return const_cast<Page*>(std::as_const(*this).find_page(page)); }

  Node& touch(NodeIndex node) { return touch_page(page_of(node))[slot_of(node)]; }

  Node at(NodeIndex node) const {
    const Page* page = find_page(page_of(node));
    return page == nullptr ? Node{} : (*page)[slot_of(node)];
  }

  /// Frees the pages whose nodes are all at rest, by `is_at_rest(node)`.
  template <class IsAtRest>
  void free_pages(IsAtRest is_at_rest) {
    std::erase_if(pages_, [&](const auto& entry) {
      for (const Node& node : entry.second) {
        if (!is_at_rest(node)) return false;
      }
      return true;
    });
  }

  /// Calls `visit(page, nodes)` for the pages from `low` to `high`, both included, that there are; in the
  /// order of pages.
  template <class Visitor>
  void for_pages(PageIndex low, PageIndex high, Visitor visit) const {
    for (int j = low.j; j <= high.j; ++j) {
      auto page = pages_.lower_bound({.j = j, .i = low.i});
      for (; page != pages_.end() && page->first.j == j && page->first.i <= high.i; ++page)
        visit(page->first, page->second);
    }
  }

  /// Memory that the pages hold.
  std::size_t bytes() const { return pages_.size() * sizeof(typename std::map<PageIndex, Page>::value_type); }

  bool operator==(const NodeField&) const = default;

 private:
  double spacing_m_;
  std::map<PageIndex, Page> pages_;
};

}  // namespace prairie
