// [wind] and what comes and goes in it.
#include <fmt/format.h>

#include "world/scene/file_key.h"
#include "world/scene/foreign_check.h"
#include "world/scene/key_ranges.h"
#include "world/scene/scene_keys.h"

namespace prairie {
namespace {

bool is_measured(const WindSpec& wind) {
  return wind.file.has_value();
}
bool is_told(const WindSpec& wind) {
  return !wind.file;
}

void refuse_beside(const TableReader& table, const char* key) {
  if (table.has(key))
    table.refuse(key, fmt::format("'{}' beside a file", key), "one of the two: the file gives it");
}

void read_file(TableReader& table, const KeyTraits& key, const Scene& so_far, WindSpec& wind) {
  wind.file = read_path(table, key, so_far, "the path of a CSV file");
  if (!wind.file) return;
  refuse_beside(table, "speed_m_per_s");
  refuse_beside(table, "heading_deg");
  // A measured series has turbulence of its own.
  if (!table.has("turbulence")) wind.turbulence = 0.0;
}

void hash_file(CanonicalText& text, const KeyTraits& key, const ContentHashes& files, const WindSpec&) {
  if (const auto content = files.find(kWindFileField); content != files.end())
    text.add(key.hash.name, content->second);
}

std::string file_text(const KeyTraits&, const Scene& scene, const WindSpec& wind) {
  return wind.file ? path_text(scene, *wind.file) : std::string();
}

void read_place(TableReader& table, const KeyTraits& key, const Scene&, WindSpec& wind) {
  if (table.has(key.name)) read_value(table, key, wind.place_m.emplace());
  if (!wind.file && table.has(key.name))
    table.refuse(key.name, "a place without a file", "the place where the file's wind was measured");
}

void hash_place(CanonicalText& text, const KeyTraits& key, const ContentHashes&, const WindSpec& wind) {
  if (wind.place_m) text.add(key.hash.name, *wind.place_m);
}

std::string place_text(const KeyTraits&, const Scene&, const WindSpec& wind) {
  return wind.place_m ? fmt::format("[{}, {}]", wind.place_m->x, wind.place_m->y) : std::string();
}

template <class Primitive>
void check_primitive(const TableReader& table, const Primitive& primitive) {
  check_by(table, ": ", [&] { check(primitive, ""); });
}

template <class Primitive>
Key<Primitive> origin_key(std::string_view hash_name) {
  return key<&Primitive::origin_m>({.name = "position_m", .range = kPositionM, .hash = {hash_name}});
}

template <class Primitive>
Key<Primitive> heading_key() {
  return key<&Primitive::heading_rad>(
      {.name = "heading_deg", .range = kBearingDeg, .unit = Unit::kBearing, .hash = {"parameter"}});
}

/// Its range is that of animation/wind_primitives.h.
template <auto parameter>
auto parameter_key(std::string_view name) {
  return key<parameter>({.name = name, .hash = {"parameter"}});
}

}  // namespace

const KeyTable<WindSpec>& wind_keys() {
  static const KeyTable<WindSpec> table{{
      key<&WindSpec::speed_m_per_s>(
          {.name = "speed_m_per_s", .range = Bounds{0.0, 60.0}, .hash = {"speed_m_per_s", 2}}, is_told),
      key<&WindSpec::heading_deg>({.name = "heading_deg", .range = kBearingDeg, .hash = {"heading_deg", 2}},
                                  is_told),
      key<&WindSpec::turbulence>({.name = "turbulence", .range = Bounds{0.0, 5.0}, .hash = {"wind", 0}}),
      {.traits = {.name = "file", .hash = {"content", 1}},
       .read = read_file,
       .hash = hash_file,
       .text = file_text,
       .applies = is_measured},
      {.traits = {.name = "place_m", .range = kPositionM, .hash = {"place_m", 1}},
       .read = read_place,
       .hash = hash_place,
       .text = place_text,
       .applies = is_measured},
  }};
  return table;
}

const KeyTable<Gust>& gust_keys() {
  static const KeyTable<Gust> table{
      {origin_key<Gust>("gust"), heading_key<Gust>(), parameter_key<&Gust::travel_m_per_s>("travel_m_per_s"),
       parameter_key<&Gust::strength_m_per_s>("strength_m_per_s"), parameter_key<&Gust::width_m>("width_m"),
       parameter_key<&Gust::depth_m>("depth_m"), parameter_key<&Gust::way_m>("way_m"),
       parameter_key<&Gust::start_s>("start_s")},
      check_primitive<Gust>};
  return table;
}

const KeyTable<Tornado>& tornado_keys() {
  static const KeyTable<Tornado> table{
      {origin_key<Tornado>("tornado"), heading_key<Tornado>(),
       parameter_key<&Tornado::travel_m_per_s>("travel_m_per_s"),
       parameter_key<&Tornado::strength_m_per_s>("strength_m_per_s"),
       parameter_key<&Tornado::radius_m>("radius_m"), parameter_key<&Tornado::reach_m>("reach_m"),
       parameter_key<&Tornado::inflow>("inflow"), parameter_key<&Tornado::wander_m>("wander_m"),
       parameter_key<&Tornado::wander_s>("wander_s"), parameter_key<&Tornado::start_s>("start_s"),
       parameter_key<&Tornado::duration_s>("duration_s"),
       key<&Tornado::seed>({.name = "seed", .hash = {"seed"}})},
      check_primitive<Tornado>};
  return table;
}

const KeyTable<Breeze>& breeze_keys() {
  static const KeyTable<Breeze> table{
      {origin_key<Breeze>("breeze"), heading_key<Breeze>(),
       parameter_key<&Breeze::strength_m_per_s>("strength_m_per_s"),
       parameter_key<&Breeze::period_s>("period_s"), parameter_key<&Breeze::wavelength_m>("wavelength_m"),
       parameter_key<&Breeze::radius_m>("radius_m")},
      check_primitive<Breeze>};
  return table;
}

}  // namespace prairie
