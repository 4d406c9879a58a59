// The key `name` of what a scene has several of: species, cameras, movers, goals, groups of walkers.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>

#include "world/scene/key.h"

namespace prairie {

/// Letters, digits, '_', '-' and spaces, a letter first, and not one of those taken. Throws BadInput.
std::string read_name(TableReader& table, const KeyTraits& key,
                      const std::function<bool(std::string_view)>& is_taken);

/// name_key<&Scene::movers, &MoverSpec::name>(): the member that holds the name, which is told apart from
/// those that the scene has in its list so far.
template <auto list, auto... members>
auto name_key(std::string_view hash_name) {
  using Element = typename std::remove_cvref_t<decltype(std::declval<Scene>().*list)>::value_type;
  return Key<Element>{
      .traits = {.name = "name", .is_required = true, .hash = {hash_name}},
      .read =
          [](TableReader& table, const KeyTraits& key, const Scene& so_far, Element& element) {
            const auto is_taken = [&](std::string_view name) {
              return std::ranges::any_of(
                  so_far.*list, [&](const Element& other) { return member::of(other, members...) == name; });
            };
            member::of(element, members...) = read_name(table, key, is_taken);
          },
      .hash = hash_member<Element, members...>,
      .text = member_text<Element, members...>};
}

}  // namespace prairie
