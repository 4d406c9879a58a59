// The field of a tread against the integral that it is the closed form of, in double and as the shaders have
// it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <random>

#include "shaders/kernels/kernels.h"
#include "tests/animation/tread_in_double.h"

namespace prairie {
namespace {

using in_double::TreadInDouble;

/// A place beside a path along x from 0 to `length_m`.
struct Place {
  double along_m, across_m, length_m, radius_m;
};

long double integrand(const Place& place, long double s) {
  const auto x = s - static_cast<long double>(place.along_m);
  const auto y = static_cast<long double>(place.across_m);
  const auto radius = static_cast<long double>(place.radius_m);
  const long double r2 = x * x + y * y + radius * radius;
  return 1.0L / (r2 * std::sqrt(r2));
}

/// Gauss and Legendre's five points.
long double by_five_points(const Place& place, long double from, long double to) {
  constexpr std::array<long double, 3> kAt = {0.0L, 0.538469310105683091036314420700L,
                                              0.906179845938663992797626878299L};
  constexpr std::array<long double, 3> kWeight = {0.568888888888888888888888888889L,
                                                  0.478628670499366468041291514836L,
                                                  0.236926885056189087514264040720L};
  const long double middle = 0.5L * (from + to), half = 0.5L * (to - from);
  long double sum = kWeight[0] * integrand(place, middle);
  for (std::size_t n = 1; n < 3; ++n) {
    sum += kWeight[n] * (integrand(place, middle - half * kAt[n]) + integrand(place, middle + half * kAt[n]));
  }
  return sum * half;
}

/// Halves intervals until both halves together agree with the whole.
long double adaptive(const Place& place, long double from, long double to, long double whole, int depth) {
  const long double middle = 0.5L * (from + to);
  const long double left = by_five_points(place, from, middle), right = by_five_points(place, middle, to);
  if (depth == 0 || std::abs(left + right - whole) <= 1e-15L * std::abs(whole)) return left + right;
  return adaptive(place, from, middle, left, depth - 1) + adaptive(place, middle, to, right, depth - 1);
}

double quadrature(const Place& place) {
  const auto length = static_cast<long double>(place.length_m);
  return static_cast<double>(adaptive(place, 0.0L, length, by_five_points(place, 0.0L, length), 40));
}

/// Floats that a double holds exactly, so that both precisions are asked the same question.
double rounded(double x) {
  return static_cast<double>(static_cast<float>(x));
}

struct Errors {
  double in_double = 0.0, in_float = 0.0;
};

Errors errors_at(const Place& place) {
  const double expected = quadrature(place);
  const double h2 = place.across_m * place.across_m + place.radius_m * place.radius_m;
  const double got = TreadInDouble{}.tread_of_path(place.along_m, place.length_m, h2);
  constexpr float kReachM = 1e4f;
  const float as_drawn =
      Kernels{}.tread_field(static_cast<float>(place.along_m), static_cast<float>(place.across_m),
                            static_cast<float>(place.length_m), static_cast<float>(place.radius_m), kReachM);
  return {std::abs(got / expected - 1.0), std::abs(static_cast<double>(as_drawn) / expected - 1.0)};
}

/// Where places lie: along the path in its lengths, across it in radii.
struct Region {
  const char* name;
  double along_min, along_max, across_min, across_max;
};

void PrintTo(const Region& region, std::ostream* out) {
  *out << region.name;
}

class TreadFieldTest : public testing::TestWithParam<Region> {};

TEST_P(TreadFieldTest, IsTheIntegralOverThePath) {
  const Region& region = GetParam();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> along(region.along_min, region.along_max),
      across(region.across_min, region.across_max), log_length(std::log(0.002), std::log(2.0)),
      log_radius(std::log(0.02), std::log(1.0));
  Errors worst;
  for (int n = 0; n < 3000; ++n) {
    Place place{};
    place.length_m = rounded(std::exp(log_length(random)));
    place.radius_m = rounded(std::exp(log_radius(random)));
    place.along_m = rounded(along(random) * place.length_m);
    place.across_m = rounded(across(random) * place.radius_m);
    const Errors errors = errors_at(place);
    worst.in_double = std::max(worst.in_double, errors.in_double);
    worst.in_float = std::max(worst.in_float, errors.in_float);
    ASSERT_LT(errors.in_double, 1e-12)
        << place.along_m << ' ' << place.across_m << ' ' << place.length_m << ' ' << place.radius_m;
    ASSERT_LT(errors.in_float, 1e-5) << place.along_m << ' ' << place.across_m << ' ' << place.length_m << ' '
                                     << place.radius_m;
  }
  RecordProperty("relative_error_double", std::to_string(worst.in_double * 1e15) + "e-15");
  RecordProperty("relative_error_float", std::to_string(worst.in_float * 1e6) + "e-6");
  std::printf("%s: largest relative error %.1e in double, %.1e in float\n", region.name, worst.in_double,
              worst.in_float);
}

INSTANTIATE_TEST_SUITE_P(Everywhere, TreadFieldTest,
                         testing::Values(Region{"beside", 0.0, 1.0, 1.0, 20.0},
                                         Region{"beyond", 1.0, 30.0, -10.0, 10.0},
                                         Region{"behind", -30.0, 0.0, -10.0, 10.0},
                                         Region{"on", 0.0, 1.0, 0.0, 0.0},
                                         Region{"near", -0.1, 1.1, -0.5, 0.5}),
                         [](const auto& region) { return std::string(region.param.name); });

/// The sum over the steps of a pass is that of the pass, whatever the steps, and also where the reach cuts
/// it.
TEST(TreadPassTest, StepsAddUpToThePass) {
  TreadInDouble kernel;
  for (const double reach_m : {0.4, 1.0, 50.0}) {
    for (double across_m = -1.2; across_m <= 1.2; across_m += 0.05) {
      const double whole = kernel.tread_field(1.3, across_m, 3.0, 0.1, reach_m);
      double sum = 0.0;
      constexpr int kSteps = 180;
      for (int n = 0; n < kSteps; ++n) {
        sum += kernel.tread_field(1.3 - 3.0 * n / kSteps, across_m, 3.0 / kSteps, 0.1, reach_m);
      }
      EXPECT_NEAR(sum, whole, 1e-12 * (1.0 + whole)) << across_m << ' ' << reach_m;
    }
  }
}

/// A body that rounds a bend is a polyline, so here steps matter.
TEST(TreadPassTest, HalvingTheTimeStepChangesThePassByLessThanAPercent) {
  const auto pass_at = [](glm::vec2 at, int steps) {
    // A walker at 1.2 m/s on a bend of 1 m for 2 s.
    float sum = 0.0f;
    const auto place = [&](int n) {
      const double angle = 2.4 * n / steps;
      return glm::vec2(std::cos(angle), std::sin(angle));
    };
    for (int n = 0; n < steps; ++n) {
      const glm::vec2 from = place(n), step = place(n + 1) - from, offset = at - from;
      const float length = std::sqrt(step.x * step.x + step.y * step.y);
      const glm::vec2 c = step / length;
      sum += Kernels{}.tread_field(c.x * offset.x + c.y * offset.y, c.x * offset.y - c.y * offset.x, length,
                                   0.1f, 0.4f);
    }
    return sum;
  };
  double worst = 0.0;
  for (float x = -0.9f; x <= 1.4f; x += 0.07f) {
    for (float y = -0.4f; y <= 1.4f; y += 0.07f) {
      const double coarse = static_cast<double>(pass_at({x, y}, 120));  // 60 Hz
      const double fine = static_cast<double>(pass_at({x, y}, 240));
      worst = std::max(worst, std::abs(coarse - fine) / std::max(fine, 2.0));  // 200 on the path
    }
  }
  std::printf("halving a step of 1/60 s changes F by at most %.2g %%\n", 100.0 * worst);
  EXPECT_LT(worst, 0.01);
}

/// E points away from the path on both sides, and along the motion.
TEST(TreadPassTest, PushesOutwardAndForward) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> turn(0.0, 6.283185307179586), place(-1.0, 1.0);
  for (int n = 0; n < 1000; ++n) {
    const double angle = turn(random);
    const glm::vec2 forward(std::cos(angle), std::sin(angle));
    const glm::vec2 left(-forward.y, forward.x);
    const float across = static_cast<float>(place(random));
    const glm::vec2 direction = Kernels{}.tread_direction(forward, across);
    const float outward = (direction.x * left.x + direction.y * left.y) * across;
    EXPECT_GT(outward, 0.0f) << across;
    EXPECT_NEAR(direction.x * forward.x + direction.y * forward.y, 1.0f, 1e-6f);
  }
  EXPECT_EQ(Kernels{}.tread_direction(glm::vec2(0.6f, 0.8f), 0.0f), glm::vec2(0.6f, 0.8f));
}

TEST(TreadPassTest, EndsSmoothlyAtItsReach) {
  const float inside = Kernels{}.tread_field(1.0f, 0.3999f, 2.0f, 0.1f, 0.4f);
  EXPECT_GT(inside, 0.0f);
  EXPECT_LT(inside, 0.3f);  // 200 on the path
  EXPECT_EQ(Kernels{}.tread_field(1.0f, 0.4001f, 2.0f, 0.1f, 0.4f), 0.0f);
  EXPECT_EQ(Kernels{}.tread_field(2.5f, 0.0f, 2.0f, 0.1f, 0.4f), 0.0f);
  EXPECT_EQ(Kernels{}.tread_field(0.2f, 0.1f, 0.0f, 0.1f, 0.4f), 0.0f) << "a body that stands makes no path";
}

/// A body that stands has pressed what it would have pressed by coming there from afar.
TEST(TreadPassTest, StandingIsHalfAPass) {
  TreadInDouble kernel;
  for (double across_m = 0.0; across_m < 0.4; across_m += 0.03) {
    const double arriving = kernel.tread_field(5.0, across_m, 5.0, 0.1, 0.4);
    EXPECT_NEAR(kernel.standing_field(across_m, 0.1, 0.4), arriving, 1e-12 * arriving);
    EXPECT_NEAR(kernel.tread_field(5.0, across_m, 10.0, 0.1, 0.4), 2.0 * arriving, 1e-12 * arriving);
  }
}

TEST(TreadPassTest, TiltApproachesItsLimit) {
  EXPECT_EQ(Kernels{}.tread_tilt(0.0f, 0.6f, 1.45f), 0.0f);
  EXPECT_NEAR(Kernels{}.tread_tilt(0.6f, 0.6f, 1.45f), 1.45f * (1.0f - std::exp(-1.0f)), 1e-6f);
  EXPECT_LE(Kernels{}.tread_tilt(1e6f, 0.6f, 1.45f), 1.45f);
}

}  // namespace
}  // namespace prairie
