// What is done with a section by its table of keys: it is read, hashed and written.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "world/scene/key.h"

namespace prairie {

/// A key of a section as TOML.
struct KeyText {
  std::string_view name;
  std::string value;
  bool is_default;
};

/// Overwrites what the table sets; it may have other keys, too. Throws BadInput.
template <class Section>
void read_keys(const KeyTable<Section>& keys, TableReader& table, const Scene& so_far, Section& section) {
  for (const Key<Section>& key : keys.keys) {
    if (!key.traits.name.empty()) key.read(table, key.traits, so_far, section);
  }
}

/// The same; every key of the table must be one of the section's.
template <class Section>
void read_section(const KeyTable<Section>& keys, TableReader& table, const Scene& so_far, Section& section) {
  read_keys(keys, table, so_far, section);
  table.refuse_unknown_keys();
  if (keys.check != nullptr) keys.check(table, section);
}

template <class Section>
bool plays_part(const Key<Section>& key, const Section& section) {
  return key.applies == nullptr || key.applies(section);
}

/// Places of the lines that are hashed, in their order.
std::vector<std::size_t> hash_order(const std::vector<HashLine>& lines);

template <class Section>
void hash_section(const KeyTable<Section>& keys, const ContentHashes& files, const Section& section,
                  CanonicalText& text) {
  std::vector<HashLine> lines;
  for (const Key<Section>& key : keys.keys) lines.push_back(key.traits.hash);
  for (const std::size_t place : hash_order(lines)) {
    const Key<Section>& key = keys.keys[place];
    if (plays_part(key, section)) key.hash(text, key.traits, files, section);
  }
}

/// Those that the section has, in the table's order. `defaults`: what a file without the key would give.
template <class Section>
std::vector<KeyText> section_texts(const KeyTable<Section>& keys, const Scene& scene, const Section& section,
                                   const Section& defaults) {
  std::vector<KeyText> texts;
  for (const Key<Section>& key : keys.keys) {
    if (!plays_part(key, section) || key.traits.name.empty()) continue;
    std::string text = key.text(key.traits, scene, section);
    if (text.empty()) continue;
    const bool is_default = !key.traits.is_required && text == key.text(key.traits, scene, defaults);
    texts.push_back({key.traits.name, std::move(text), is_default});
  }
  return texts;
}

}  // namespace prairie
