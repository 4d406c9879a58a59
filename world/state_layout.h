// What lies behind the header of a state file, as the head of world/state_file.h tells it: of each struct the
// fields that are kept, once, in their order. An archive (world/state_archive.h) says what is done with them;
// those that write get const structs.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <type_traits>
#include <vector>

#include "files/little_endian.h"
#include "world/state_archive.h"
#include "world/state_file.h"

namespace prairie {

/// A struct, const or not.
template <class Value, class Struct>
concept Is = std::same_as<std::remove_const_t<Value>, Struct>;

template <class Archive, class... Fields>
void visit_fields(Archive& archive, Fields&... fields) {
  (visit(archive, fields), ...);
}

/// How many bytes such a value takes.
template <class Value>
std::size_t bytes_of(const Value& value) {
  std::size_t bytes = 0;
  StateWriter counter([&](auto number) { bytes += sizeof(number); });
  visit(counter, value);
  return bytes;
}

template <class Archive, class Number>
requires FixedWidth<std::remove_const_t<Number>>
void visit(Archive& archive, Number& number) {
  archive.number(number);
}

template <class Archive, class Flag>
void visit_flag(Archive& archive, Flag& flag) {
  const bool is_set = archive.flag(flag);
  if constexpr (Archive::kReads) flag = is_set;
}

template <class Archive, class Elements>
void visit_each(Archive& archive, Elements& elements) {
  for (auto& element : elements) visit(archive, element);
}

/// `smallest`: an element that takes the fewest bytes.
template <class Width, class Archive, class List>
void visit_list(Archive& archive, List& list, const typename List::value_type& smallest = {}) {
  const std::size_t count = archive.template count<Width>(list.size(), bytes_of(smallest));
  if constexpr (Archive::kReads) list.resize(count);
  visit_each(archive, list);
}

void visit(auto& archive, Is<glm::vec2> auto& v) {
  visit_fields(archive, v.x, v.y);
}

void visit(auto& archive, Is<glm::vec3> auto& v) {
  visit_fields(archive, v.x, v.y, v.z);
}

void visit(auto& archive, Is<glm::dvec2> auto& v) {
  visit_fields(archive, v.x, v.y);
}

template <class Archive>
void visit_settings(Archive& archive, const TreadSettings& settings) {
  archive.expect("spacing_m", settings.spacing_m);
  archive.expect("reach_radii", settings.reach_radii);
  archive.expect("recovery_s", settings.recovery_s);
  archive.expect("field_scale", settings.field_scale);
  archive.expect("most_tilt_rad", settings.most_tilt_rad);
  archive.expect("load_slowing", settings.load_slowing);
  archive.expect("worn_slowing", settings.worn_slowing);
  archive.expect("wear_passes", settings.wear_passes);
  archive.expect("worn_field", settings.worn_field);
}

void visit(auto& archive, Is<PageIndex> auto& page) {
  visit_fields(archive, page.j, page.i);
}

void visit(auto& archive, Is<TreadNode> auto& node) {
  visit_fields(archive, node.start_s, node.field, node.recovery_s, node.blades_recovery_s, node.direction);
}

void visit(auto& archive, Is<NodeField<TreadNode>::Page> auto& nodes) {
  visit_each(archive, nodes);
}

void visit(auto& archive, Is<NodeField<float>::Page> auto& values) {
  visit_each(archive, values);
}

template <class Archive, class Field>
void visit_pages(Archive& archive, Field& field) {
  const std::size_t page_bytes = bytes_of(PageIndex{}) + bytes_of(typename Field::Page{});
  const std::size_t count = archive.template count<std::uint64_t>(field.pages().size(), page_bytes);
  if constexpr (Archive::kReads) {
    std::optional<PageIndex> last;
    for (std::size_t n = 0; n < count; ++n) {
      PageIndex index;
      visit(archive, index);
      if (last && !(*last < index))
        archive.refuse("pages out of order or twice", "each once, from south to north");
      last = index;
      visit(archive, field.touch_page(index));
    }
  } else {
    for (const auto& [index, nodes] : field.pages()) visit_fields(archive, index, nodes);
  }
}

void visit(auto& archive, Is<ChainVectors> auto& vectors) {
  visit_fields(archive, vectors.v1, vectors.v2, vectors.v3, vectors.v4);
}

void visit(auto& archive, Is<ChainMotion> auto& motion) {
  visit_fields(archive, motion.turn, motion.rate);
}

void visit(auto& archive, Is<Foot> auto& foot) {
  visit_fields(archive, foot.position_m, foot.forward);
  visit_flag(archive, foot.planted);
  visit_fields(archive, foot.share, foot.lift_phase);
}

void visit(auto& archive, Is<Footing> auto& footing) {
  visit_fields(archive, footing.scale, footing.phase, footing.speed_m_per_s);
  visit_each(archive, footing.feet);
}

void visit(auto& archive, Is<Memory> auto& memory) {
  visit_fields(archive, memory.turn, memory.turned_s, memory.goal, memory.goal_since_s, memory.met_m,
               memory.met_s, memory.moved_s, memory.backs_off_until_s);
}

void visit(auto& archive, Is<Walker> auto& walker) {
  visit_fields(archive, walker.position_m, walker.forward, walker.speed_m_per_s, walker.footing,
               walker.memory);
}

void visit(auto& archive, Is<TouchedBlade> auto& blade) {
  visit_fields(archive, blade.index, blade.motion, blade.rest, blade.offset, blade.rise, blade.near_steps,
               blade.fades);
}

void visit(auto& archive, Is<TouchedState::value_type> auto& cell) {
  auto& [id, blades] = cell;
  visit_fields(archive, id.tile.i, id.tile.j, id.cell);
  visit_list<std::uint32_t>(archive, blades);
}

template <class Archive, class Eye>
void visit_eye(Archive& archive, Eye& eye_m) {
  const bool is_there = archive.flag(eye_m.has_value());
  if constexpr (Archive::kReads) {
    if (is_there) eye_m.emplace();
  }
  if (is_there) visit(archive, *eye_m);
}

/// It has its centre where the eye is.
template <class Archive, class Sway>
void visit_sway(Archive& archive, const std::optional<glm::dvec2>& eye_m, Sway& sway) {
  const bool is_there = archive.flag(sway.has_value());
  if constexpr (Archive::kReads) {
    if (is_there && !eye_m) archive.refuse("swaying blades without an eye", "an eye that watches them");
    if (is_there) sway.emplace().centre_m = *eye_m;
  }
  if (is_there) visit_list<std::uint64_t>(archive, sway->motions);
}

/// All of it. What is read goes into a state without pages.
template <class Archive, class State>
void visit_state(Archive& archive, const TreadSettings& settings, State& state) {
  auto& motion = state.motion;
  archive.enter("time");
  visit(archive, motion.ticks);
  archive.enter("treading");
  visit_settings(archive, settings);
  archive.enter("trodden");
  visit_pages(archive, motion.treading.nodes);
  archive.enter("worn");
  visit_pages(archive, motion.treading.wear);
  archive.enter("eye");
  visit_eye(archive, motion.eye_m);
  archive.enter("sway");
  visit_sway(archive, motion.eye_m, motion.sway);
  archive.enter("walkers");
  visit_list<std::uint64_t>(archive, state.walkers);
  archive.enter("touched");
  const TouchedState::value_type smallest{CellId{}, std::vector<TouchedBlade>(1)};
  visit_list<std::uint64_t>(archive, motion.touched, smallest);
}

}  // namespace prairie
