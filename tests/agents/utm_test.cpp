#include "agents/utm.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "maps/georaster/spatial_reference.h"

namespace prairie {
namespace {

constexpr double kRadPerDeg = 0.017453292519943295;

/// Snyder, Map Projections: A Working Manual (USGS PP 1395, 1987), equations 3-21 and 8-9 to 8-15, on WGS 84;
/// millimetres within a zone.
glm::dvec2 snyder_m(const UtmZone& zone, GeoPoint point) {
  constexpr double a = 6378137.0, f = 1.0 / 298.257223563, e2 = f * (2.0 - f), k0 = 0.9996;
  constexpr double e4 = e2 * e2, e6 = e4 * e2, ep2 = e2 / (1.0 - e2);
  const double phi = point.latitude_deg * kRadPerDeg;
  const double lambda = degrees_from_meridian(zone, point) * kRadPerDeg;
  const double N = a / std::sqrt(1.0 - e2 * std::sin(phi) * std::sin(phi));
  const double T = std::tan(phi) * std::tan(phi), C = ep2 * std::cos(phi) * std::cos(phi),
               A = lambda * std::cos(phi);
  const double M = a * ((1.0 - e2 / 4.0 - 3.0 * e4 / 64.0 - 5.0 * e6 / 256.0) * phi -
                        (3.0 * e2 / 8.0 + 3.0 * e4 / 32.0 + 45.0 * e6 / 1024.0) * std::sin(2.0 * phi) +
                        (15.0 * e4 / 256.0 + 45.0 * e6 / 1024.0) * std::sin(4.0 * phi) -
                        35.0 * e6 / 3072.0 * std::sin(6.0 * phi));
  const double A2 = A * A, A3 = A2 * A, A4 = A2 * A2, A5 = A4 * A, A6 = A3 * A3;
  const double x =
      k0 * N * (A + (1.0 - T + C) * A3 / 6.0 + (5.0 - 18.0 * T + T * T + 72.0 * C - 58.0 * ep2) * A5 / 120.0);
  const double y = k0 * (M + N * std::tan(phi) *
                                 (A2 / 2.0 + (5.0 - T + 9.0 * C + 4.0 * C * C) * A4 / 24.0 +
                                  (61.0 - 58.0 * T + T * T + 600.0 * C - 330.0 * ep2) * A6 / 720.0));
  return {500'000.0 + x, y + (zone.north ? 0.0 : 10'000'000.0)};
}

TEST(Utm, AgreesWithASecondFormula) {
  const GeoPoint points[] = {{45.45, 14.02}, {45.38, 14.144}, {39.1, -96.6},  {-33.86, 151.21}, {0.0, 3.0},
                             {64.1, -21.9},  {-54.8, -68.3},  {45.78, 14.36}, {1.0, 179.99}};
  for (const GeoPoint& point : points) {
    const UtmZone zone = standard_utm_zone(point);
    EXPECT_LE(std::abs(degrees_from_meridian(zone, point)), 3.0);
    EXPECT_LT(glm::distance(utm_m(zone, point), snyder_m(zone, point)), 0.005)
        << point.latitude_deg << ' ' << point.longitude_deg;
  }
}

TEST(Utm, AgreesWithPublishedCoordinates) {
  // The example of GeoConvert's manual page: 33.3 N 44.4 E is 38n 444140.54 3684706.36.
  const GeoPoint baghdad{33.3, 44.4};
  const UtmZone zone = standard_utm_zone(baghdad);
  EXPECT_EQ(zone, (UtmZone{38, true}));
  EXPECT_NEAR(utm_m(zone, baghdad).x, 444140.54, 0.006);
  EXPECT_NEAR(utm_m(zone, baghdad).y, 3684706.36, 0.006);
}

TEST(Utm, KnowsTheZones) {
  EXPECT_EQ(standard_utm_zone({45.45, 14.02}), (UtmZone{33, true}));
  EXPECT_EQ(standard_utm_zone({39.1, -96.6}), (UtmZone{14, true}));
  EXPECT_EQ(standard_utm_zone({-33.86, 151.21}), (UtmZone{56, false}));
  EXPECT_EQ(standard_utm_zone({60.4, 5.3}), (UtmZone{32, true})) << "Bergen";
  EXPECT_EQ(standard_utm_zone({10.0, 180.0}).number, 1);
  EXPECT_EQ(standard_utm_zone({10.0, -180.0}).number, 1);
  EXPECT_NEAR(degrees_from_meridian({1, true}, {0.0, 179.0}), -4.0, 1e-12);
}

TEST(Utm, ANeighboursZoneAndTheOtherHalfServeToo) {
  const GeoPoint point{-0.001, 12.1};
  const glm::dvec2 north_m = utm_m({33, true}, point), south_m = utm_m({33, false}, point);
  EXPECT_NEAR(south_m.y - north_m.y, 1e7, 1e-6);
  EXPECT_LT(north_m.y, 0.0);
  EXPECT_GT(utm_m({32, true}, point).x, 800'000.0);
}

TEST(Utm, ReadsTheZoneFromAMapsSystem) {
  GeoReference reference;
  reference.west_m = 702000.5;
  reference.south_m = 4333000.5;
  EXPECT_FALSE(utm_zone_of(reference));
  const auto with_code = [&](int code) {
    reference.wkt = SpatialReference::of_name(fmt::format("EPSG:{}", code))->wkt();
    return utm_zone_of(reference);
  };
  EXPECT_EQ(with_code(32614), (UtmZone{14, true}));
  EXPECT_EQ(with_code(32660), (UtmZone{60, true}));
  EXPECT_EQ(with_code(32701), (UtmZone{1, false}));
  for (const int code : {32661, 32761, 3857, 2154}) EXPECT_FALSE(with_code(code)) << code;
  with_code(32733);
  ASSERT_TRUE(utm_frame_of(reference));
  EXPECT_EQ(utm_frame_of(reference)->zone, (UtmZone{33, false}));
  EXPECT_EQ(utm_frame_of(reference)->origin_m, glm::dvec2(702000.5, 4333000.5));
  reference.wkt = "PROJCS[";
  EXPECT_FALSE(utm_zone_of(reference));
  EXPECT_FALSE(utm_frame_of(reference));
}

}  // namespace
}  // namespace prairie
