// [[obstacle]], by its kind, and [[wall]]. Ranges are those of agents/obstacle.h.
#include "world/scene/foreign_check.h"
#include "world/scene/key_ranges.h"
#include "world/scene/scene_keys.h"

namespace prairie {
namespace {

constexpr Bounds kSizeM{0.0, 1e6};  // wider than any that is allowed

template <class Thing>
void check_thing(const TableReader& table, const Thing& thing) {
  check_by(table, "", [&] { check(thing); });
}

template <class Thing>
Key<Thing> place_key(std::string_view hash_name) {
  return key<&Thing::position_m>(
      {.name = "position_m", .range = kPositionM, .is_required = true, .hash = {hash_name}});
}

template <class Thing>
Key<Thing> size_key() {
  return key<&Thing::size_m>({.name = "size_m", .range = kSizeM, .hash = {"size_m"}});
}

template <class Thing>
Key<Thing> heading_key() {
  return key<&Thing::heading_rad>(
      {.name = "heading_deg", .range = kBearingDeg, .unit = Unit::kBearing, .hash = {"heading_rad"}});
}

void hash_holes(CanonicalText& text, const KeyTraits& key, const ContentHashes&, const Wall& wall) {
  for (const auto& hole_m : wall.outline.holes_m) {
    text.add(key.hash.name, std::uint64_t{hole_m.size()});
    text.add("hole_m", hole_m);
  }
}

}  // namespace

const KeyTable<Trunk>& trunk_keys() {
  static const KeyTable<Trunk> table{
      {place_key<Trunk>("trunk"), key<&Trunk::radius_m>({.name = "radius_m", .hash = {"radius_m"}}),
       key<&Trunk::height_m>({.name = "height_m", .hash = {"height_m"}})},
      check_thing<Trunk>};
  return table;
}

const KeyTable<Block>& box_keys() {
  static const KeyTable<Block> table{{place_key<Block>("box"), size_key<Block>(), heading_key<Block>()},
                                     check_thing<Block>};
  return table;
}

const KeyTable<Rock>& rock_keys() {
  static const KeyTable<Rock> table{{place_key<Rock>("rock"), size_key<Rock>(), heading_key<Rock>(),
                                     key<&Rock::seed>({.name = "seed", .hash = {"seed"}})},
                                    check_thing<Rock>};
  return table;
}

const KeyTable<Wall>& wall_keys() {
  static const KeyTable<Wall> table{
      {key<&Wall::outline, &WallPolygon::outer_m>(
           {.name = "outline_m", .counts = {3, kMaxPathPoints}, .is_required = true, .hash = {"outer_m", 2}}),
       {.traits = {.name = "holes_m", .counts = {3, kMaxPathPoints}, .hash = {"hole", 3}},
        .read = read_member<Wall, &Wall::outline, &WallPolygon::holes_m>,
        .hash = hash_holes,
        .text = member_text<Wall, &Wall::outline, &WallPolygon::holes_m>},
       key<&Wall::walkers>({.name = "walkers", .words = {"inside", "outside"}, .hash = {"wall", 0}}),
       key<&Wall::height_m>({.name = "height_m", .hash = {"height_m", 1}})},
      check_thing<Wall>};
  return table;
}

}  // namespace prairie
