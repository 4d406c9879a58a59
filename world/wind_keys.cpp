#include "world/wind_keys.h"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <utility>

#include "world/bearing.h"
#include "world/foreign_check.h"

namespace prairie {
namespace {

constexpr Bounds kSpeedMPerS{0.0, 60.0};
constexpr Bounds kBearingDeg{-360.0, 360.0};
constexpr Bounds kPositionM{-1e6, 1e6};
constexpr Bounds kTurbulence{0.0, 5.0};

template <class Primitive>
struct NumberKey {
  const char* key;  // as the member
  double Primitive::*member;
};

// Their ranges are those of animation/wind_primitives.h.
constexpr NumberKey<Gust> kGustKeys[] = {
    {"travel_m_per_s", &Gust::travel_m_per_s},
    {"strength_m_per_s", &Gust::strength_m_per_s},
    {"width_m", &Gust::width_m},
    {"depth_m", &Gust::depth_m},
    {"way_m", &Gust::way_m},
    {"start_s", &Gust::start_s},
};

constexpr NumberKey<Tornado> kTornadoKeys[] = {
    {"travel_m_per_s", &Tornado::travel_m_per_s},
    {"strength_m_per_s", &Tornado::strength_m_per_s},
    {"radius_m", &Tornado::radius_m},
    {"reach_m", &Tornado::reach_m},
    {"inflow", &Tornado::inflow},
    {"wander_m", &Tornado::wander_m},
    {"wander_s", &Tornado::wander_s},
    {"start_s", &Tornado::start_s},
    {"duration_s", &Tornado::duration_s},
};

constexpr NumberKey<Breeze> kBreezeKeys[] = {
    {"strength_m_per_s", &Breeze::strength_m_per_s},
    {"period_s", &Breeze::period_s},
    {"wavelength_m", &Breeze::wavelength_m},
    {"radius_m", &Breeze::radius_m},
};

const auto& number_keys(const Gust&) {
  return kGustKeys;
}
const auto& number_keys(const Tornado&) {
  return kTornadoKeys;
}
const auto& number_keys(const Breeze&) {
  return kBreezeKeys;
}

void read_more(TableReader&, Gust&) {}
void read_more(TableReader& table, Tornado& tornado) {
  const auto seed = table.integer("seed", 0, std::numeric_limits<std::uint32_t>::max());
  if (seed) tornado.seed = static_cast<std::uint32_t>(*seed);
}
void read_more(TableReader&, Breeze&) {}

template <class Primitive>
WindPrimitive read_primitive(TableReader& table) {
  Primitive primitive;
  if (const auto place_m = table.pair("position_m", kPositionM))
    primitive.origin_m = {(*place_m)[0], (*place_m)[1]};
  if (const auto bearing_deg = table.number("heading_deg", kBearingDeg))
    primitive.heading_rad = heading_rad_of(*bearing_deg);
  for (const auto& [key, member] : number_keys(primitive))
    primitive.*member = table.any_number(key).value_or(primitive.*member);
  read_more(table, primitive);
  table.refuse_unknown_keys();
  check_by(table, ": ", [&] { check(primitive, ""); });
  return primitive;
}

template <class Primitive>
void read_primitives(TableReader& wind, const char* key, std::vector<WindPrimitive>& primitives) {
  for (TableReader& table : wind.tables(key)) {
    if (primitives.size() == kMaxWindPrimitives) {
      wind.refuse(key, fmt::format("more than {} gusts, tornadoes and breezes", kMaxWindPrimitives),
                  fmt::format("at most {}", kMaxWindPrimitives));
    }
    primitives.push_back(read_primitive<Primitive>(table));
  }
}

void refuse_beside(const TableReader& table, const char* key, bool is_there) {
  if (is_there)
    table.refuse(key, fmt::format("'{}' beside a file", key), "one of the two: the file gives it");
}

}  // namespace

WindSpec read_wind(TableReader& table, const std::filesystem::path& folder) {
  WindSpec wind;
  const auto speed_m_per_s = table.number("speed_m_per_s", kSpeedMPerS);
  const auto heading_deg = table.number("heading_deg", kBearingDeg);
  const auto turbulence = table.number("turbulence", kTurbulence);
  const auto file = table.text("file");
  const auto place_m = table.pair("place_m", kPositionM);
  if (file) {
    if (file->empty() || file->find('\0') != std::string::npos)
      table.refuse("file", "the path of a CSV file");
    refuse_beside(table, "speed_m_per_s", speed_m_per_s.has_value());
    refuse_beside(table, "heading_deg", heading_deg.has_value());
    wind.file = folder / *file;
  } else if (place_m) {
    table.refuse("place_m", "a place without a file", "the place where the file's wind was measured");
  }
  wind.speed_m_per_s = speed_m_per_s.value_or(wind.speed_m_per_s);
  wind.heading_deg = heading_deg.value_or(wind.heading_deg);
  if (place_m) wind.place_m = {(*place_m)[0], (*place_m)[1]};
  // A measured series has turbulence of its own.
  wind.turbulence = turbulence.value_or(file ? 0.0 : wind.turbulence);
  read_primitives<Gust>(table, "gust", wind.primitives);
  read_primitives<Tornado>(table, "tornado", wind.primitives);
  read_primitives<Breeze>(table, "breeze", wind.primitives);
  table.refuse_unknown_keys();
  return wind;
}

}  // namespace prairie
