// A row of the table of keys that a section of a scene's file has (world/scene/scene_keys.h): its name, the
// member that it fills, its range and unit, and its place in the hash, as data; and how it is read, hashed
// and written, which mostly follows from the member's type (world/scene/key_values.h).
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "world/scene/canonical_text.h"
#include "world/scene/key_traits.h"
#include "world/scene/key_values.h"
#include "world/scene/scene.h"
#include "world/scene/scene_hash.h"
#include "world/scene/toml_reader.h"

namespace prairie {

template <class Section>
struct Key {
  KeyTraits traits;
  /// `so_far`: what has been read of the scene before. Throws BadInput.
  void (*read)(TableReader& table, const KeyTraits& key, const Scene& so_far, Section& section);
  void (*hash)(CanonicalText& text, const KeyTraits& key, const ContentHashes& files, const Section& section);
  /// As TOML; empty where the section goes without the key.
  std::string (*text)(const KeyTraits& key, const Scene& scene, const Section& section);
  /// Where not null and false, the key plays no part: it is neither hashed nor written.
  bool (*applies)(const Section& section) = nullptr;
};

template <class Section>
struct KeyTable {
  std::vector<Key<Section>> keys;
  /// Where not null, judges the section once it has been read; throws BadInput.
  void (*check)(const TableReader& table, const Section& section) = nullptr;
};

namespace member {

template <class Member>
struct Owner;
template <class Class, class Type>
struct Owner<Type Class::*> {
  using type = Class;
};
template <auto first>
using owner_t = typename Owner<decltype(first)>::type;

template <class Object>
auto& of(Object& object) {
  return object;
}
template <class Object, class Member, class... Members>
auto& of(Object& object, Member first, Members... rest) {
  return of(object.*first, rest...);
}

}  // namespace member

// The parts of a row that follow from the member's type: key<&SunSpec::color>({…}), or, for a member of a
// member, key<&MoverSpec::path, &MoverPath::radius_m>({…}).

template <class Section, auto... members>
void read_member(TableReader& table, const KeyTraits& key, const Scene&, Section& section) {
  read_value(table, key, member::of(section, members...));
}

template <class Section, auto... members>
void hash_member(CanonicalText& text, const KeyTraits& key, const ContentHashes&, const Section& section) {
  text.add(key.hash.name, member::of(section, members...));
}

template <class Section, auto... members>
std::string member_text(const KeyTraits& key, const Scene&, const Section& section) {
  return value_text(key, member::of(section, members...));
}

template <auto first, auto... rest>
Key<member::owner_t<first>> key(KeyTraits traits, bool (*applies)(const member::owner_t<first>&) = nullptr) {
  using Section = member::owner_t<first>;
  return {.traits = std::move(traits),
          .read = read_member<Section, first, rest...>,
          .hash = hash_member<Section, first, rest...>,
          .text = member_text<Section, first, rest...>,
          .applies = applies};
}

}  // namespace prairie
