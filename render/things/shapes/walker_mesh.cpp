#include "render/things/shapes/walker_mesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "agents/skeleton.h"
#include "maps/catmull_rom.h"
#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

using enum Joint;

/// An oval: its middle, how far it reaches to the left and right, forward (or up) and back (or down).
struct Ring {
  double along, middle, left, front, back;  // along the part's axis; the middle along front
  double aside = 0.0;                       // of the middle, to the left of the part's
};

/// Shifts of a part's rings, and how square they are, are the same along the part.
enum class Axis { kUp, kForward };  // of a tube: up, its rings level; or forward, its rings upright

/// Which joints carry a place: from `upper` to `lower` over a stretch of the part's axis.
struct Joining {
  Joint first, second;
  double from, to;  // all of the first at `from`, all of the second at `to`
};

struct Part {
  Axis axis;
  std::uint32_t material;
  std::span<const Ring> rings;
  std::span<const Joining> joinings;
  double left = 0.0;     // of the rings' middles
  double square = 2.0;   // exponent of the superellipse
  double crowded = 0.0;  // 0…0.6: vertices gather in front
  bool is_paired = true;
  std::array<int, kWalkerLevels> ring_count{};  // by level; 0: left out
  std::array<int, kWalkerLevels> segment_count{};
};

// Lengths in metres, of the resting figure, from the bottom up (or from the heel on).
constexpr std::array kJacket = {
    Ring{0.836, -0.004, 0.170, 0.112, 0.126}, Ring{0.844, -0.004, 0.184, 0.126, 0.140},
    Ring{0.900, -0.006, 0.184, 0.124, 0.141}, Ring{0.970, -0.010, 0.174, 0.116, 0.129},
    Ring{1.050, -0.012, 0.158, 0.111, 0.110}, Ring{1.130, -0.014, 0.156, 0.115, 0.106},
    Ring{1.210, -0.016, 0.166, 0.122, 0.112}, Ring{1.290, -0.018, 0.178, 0.124, 0.120},
    Ring{1.360, -0.020, 0.188, 0.114, 0.120}, Ring{1.405, -0.022, 0.190, 0.096, 0.110},
    Ring{1.440, -0.022, 0.164, 0.078, 0.092}, Ring{1.466, -0.018, 0.112, 0.064, 0.078},
    Ring{1.492, -0.012, 0.068, 0.062, 0.066}, Ring{1.512, -0.008, 0.063, 0.062, 0.062},
    Ring{1.516, -0.007, 0.057, 0.056, 0.056}};
constexpr std::array kTrunkJoints = {Joining{kPelvis, kSpine, 0.95, 1.07},
                                     Joining{kSpine, kChest, 1.10, 1.24}, Joining{kChest, kNeck, 1.44, 1.51}};

constexpr std::array kNeckRings = {
    Ring{1.450, -0.012, 0.050, 0.046, 0.050}, Ring{1.490, -0.008, 0.052, 0.050, 0.054},
    Ring{1.530, 0.000, 0.052, 0.050, 0.056}, Ring{1.575, 0.006, 0.050, 0.046, 0.056}};
constexpr std::array kNeckJoints = {Joining{kChest, kNeck, 1.44, 1.49}, Joining{kNeck, kHead, 1.51, 1.57}};

constexpr std::array kHeadRings = {
    Ring{1.520, 0.034, 0.022, 0.036, 0.030}, Ring{1.525, 0.030, 0.040, 0.060, 0.046},
    Ring{1.542, 0.024, 0.051, 0.075, 0.060}, Ring{1.566, 0.020, 0.060, 0.080, 0.082},
    Ring{1.595, 0.016, 0.067, 0.083, 0.094}, Ring{1.625, 0.013, 0.071, 0.084, 0.100},
    Ring{1.655, 0.011, 0.074, 0.087, 0.102}, Ring{1.685, 0.008, 0.074, 0.085, 0.099},
    Ring{1.712, 0.005, 0.067, 0.074, 0.088}, Ring{1.733, 0.003, 0.052, 0.055, 0.066},
    Ring{1.746, 0.001, 0.030, 0.031, 0.038}};
constexpr std::array kHeadJoints = {Joining{kNeck, kHead, 1.505, 1.53}};

constexpr std::array kEar = {
    Ring{1.582, -0.002, 0.004, 0.006, 0.006}, Ring{1.592, -0.002, 0.009, 0.011, 0.012},
    Ring{1.610, -0.002, 0.011, 0.015, 0.018}, Ring{1.630, -0.004, 0.011, 0.015, 0.020},
    Ring{1.642, -0.006, 0.006, 0.008, 0.011}};

constexpr std::array kTrouserLeg = {
    Ring{0.072, 0.000, 0.050, 0.056, 0.054},  Ring{0.078, 0.000, 0.056, 0.066, 0.062},
    Ring{0.120, -0.004, 0.055, 0.060, 0.060}, Ring{0.200, -0.010, 0.056, 0.056, 0.062},
    Ring{0.300, -0.012, 0.060, 0.058, 0.070}, Ring{0.380, -0.010, 0.062, 0.060, 0.071},
    Ring{0.450, -0.004, 0.062, 0.064, 0.064}, Ring{0.500, 0.000, 0.063, 0.068, 0.062},
    Ring{0.560, 0.000, 0.067, 0.071, 0.070},  Ring{0.660, 0.000, 0.075, 0.079, 0.082},
    Ring{0.760, 0.000, 0.081, 0.085, 0.091},  Ring{0.830, -0.004, 0.084, 0.088, 0.098},
    Ring{0.880, -0.010, 0.070, 0.074, 0.088}, Ring{0.930, -0.010, 0.046, 0.050, 0.060}};
constexpr std::array kLegJoints = {Joining{kLeftAnkle, kLeftKnee, 0.060, 0.085},
                                   Joining{kLeftKnee, kLeftHip, 0.43, 0.565},
                                   Joining{kLeftHip, kPelvis, 0.87, 1.00}};

constexpr std::array kSleeve = {
    Ring{0.842, -0.013, 0.026, 0.030, 0.028},         Ring{0.846, -0.013, 0.033, 0.038, 0.036},
    Ring{0.880, -0.013, 0.035, 0.040, 0.038},         Ring{0.950, -0.014, 0.039, 0.043, 0.042},
    Ring{1.030, -0.015, 0.043, 0.046, 0.047},         Ring{1.090, -0.016, 0.044, 0.046, 0.049},
    Ring{1.160, -0.015, 0.046, 0.049, 0.051},         Ring{1.260, -0.015, 0.051, 0.055, 0.056},
    Ring{1.330, -0.016, 0.055, 0.060, 0.061},         Ring{1.375, -0.018, 0.056, 0.062, 0.064, -0.003},
    Ring{1.410, -0.020, 0.053, 0.059, 0.062, -0.010}, Ring{1.436, -0.021, 0.042, 0.049, 0.053, -0.022},
    Ring{1.451, -0.021, 0.026, 0.034, 0.038, -0.036}, Ring{1.456, -0.021, 0.010, 0.015, 0.017, -0.046}};
constexpr std::array kArmJoints = {Joining{kLeftElbow, kLeftShoulder, 1.04, 1.14},
                                   Joining{kLeftShoulder, kChest, 1.41, 1.56}};

constexpr std::array kHand = {
    Ring{0.655, 0.004, 0.006, 0.014, 0.014},  Ring{0.664, 0.003, 0.010, 0.027, 0.026},
    Ring{0.690, 0.000, 0.012, 0.034, 0.033},  Ring{0.720, -0.004, 0.013, 0.038, 0.036},
    Ring{0.755, -0.008, 0.015, 0.041, 0.038}, Ring{0.790, -0.011, 0.017, 0.038, 0.036},
    Ring{0.820, -0.013, 0.020, 0.030, 0.028}, Ring{0.870, -0.013, 0.022, 0.027, 0.026}};
constexpr std::array kHandJoints = {Joining{kLeftWrist, kLeftElbow, 0.82, 0.86}};
constexpr std::array kThumb = {
    Ring{0.722, 0.047, 0.006, 0.006, 0.006}, Ring{0.730, 0.045, 0.010, 0.010, 0.010},
    Ring{0.755, 0.036, 0.011, 0.012, 0.012}, Ring{0.785, 0.018, 0.013, 0.015, 0.015},
    Ring{0.810, 0.000, 0.010, 0.012, 0.012}};

// Along forward; here `front` is up and `back` down.
constexpr std::array kShoe = {
    Ring{-0.064, 0.034, 0.020, 0.024, 0.028}, Ring{-0.056, 0.044, 0.031, 0.042, 0.044},
    Ring{-0.030, 0.052, 0.037, 0.056, 0.052}, Ring{0.010, 0.051, 0.038, 0.055, 0.051},
    Ring{0.050, 0.044, 0.040, 0.042, 0.044},  Ring{0.090, 0.035, 0.045, 0.032, 0.035},
    Ring{0.130, 0.029, 0.048, 0.027, 0.029},  Ring{0.165, 0.025, 0.045, 0.023, 0.024},
    Ring{0.192, 0.022, 0.034, 0.017, 0.019},  Ring{0.205, 0.021, 0.018, 0.010, 0.014}};
constexpr std::array kShoeJoints = {Joining{kLeftAnkle, kLeftToes, 0.095, 0.150}};

constexpr double kLegLeft = kHalfHipsM, kArmLeft = kHalfShouldersM + 0.006;

constexpr std::array kParts = {
    Part{Axis::kUp,
         layouts::kWalkerJacket,
         kJacket,
         kTrunkJoints,
         0.0,
         2.35,
         0.0,
         false,
         {28, 13, 6},
         {24, 12, 6}},
    Part{Axis::kUp,
         layouts::kWalkerSkin,
         kNeckRings,
         kNeckJoints,
         0.0,
         2.0,
         0.0,
         false,
         {6, 3, 2},
         {14, 7, 3}},
    Part{Axis::kUp,
         layouts::kWalkerHead,
         kHeadRings,
         kHeadJoints,
         0.0,
         2.1,
         0.55,
         false,
         {30, 9, 5},
         {32, 10, 5}},
    Part{Axis::kUp, layouts::kWalkerSkin, kEar, kHeadJoints, 0.077, 2.0, 0.0, true, {6, 0, 0}, {7, 0, 0}},
    Part{Axis::kUp,
         layouts::kWalkerTrousers,
         kTrouserLeg,
         kLegJoints,
         kLegLeft,
         2.1,
         0.0,
         true,
         {24, 11, 5},
         {16, 8, 4}},
    Part{Axis::kUp,
         layouts::kWalkerJacket,
         kSleeve,
         kArmJoints,
         kArmLeft,
         2.0,
         0.0,
         true,
         {20, 9, 4},
         {14, 7, 3}},
    Part{Axis::kUp,
         layouts::kWalkerSkin,
         kHand,
         kHandJoints,
         kArmLeft,
         2.3,
         0.0,
         true,
         {10, 4, 2},
         {10, 5, 3}},
    Part{Axis::kUp,
         layouts::kWalkerSkin,
         kThumb,
         kHandJoints,
         kArmLeft - 0.010,
         2.0,
         0.0,
         true,
         {6, 0, 0},
         {7, 0, 0}},
    Part{Axis::kForward,
         layouts::kWalkerShoes,
         kShoe,
         kShoeJoints,
         kLegLeft,
         2.6,
         0.0,
         true,
         {16, 6, 3},
         {12, 6, 3}},
};

constexpr double kSkirtM = 0.97;  // below it the jacket follows the legs

double bump(double x, double width) {
  return std::exp(-x * x / (width * width));
}

/// What makes a head of an egg: nose, sockets of the eyes, chin, and hair as thick as it is.
glm::dvec3 with_features(glm::dvec3 p) {
  const double front = std::clamp((p.x - 0.05) / 0.03, 0.0, 1.0), side = std::abs(p.y);
  const double nose_z = std::clamp((1.648 - p.z) / 0.050, 0.0, 1.0);
  const double under_nose = std::clamp((p.z - 1.586) / 0.010, 0.0, 1.0);
  p.x += front * 0.024 * nose_z * under_nose * bump(p.y, 0.0085 + 0.006 * nose_z);
  p.x -= front * 0.0085 * bump(side - 0.032, 0.019) * bump(p.z - 1.633, 0.0125);
  p.x += front * 0.0035 * bump(p.z - 1.658, 0.010) * bump(side - 0.028, 0.03);
  p.x += front * 0.004 * bump(p.y, 0.022) * bump(p.z - 1.5655, 0.009);
  p.x += front * 0.007 * bump(p.y, 0.022) * bump(p.z - 1.538, 0.012);
  // Between nape, ears and forehead.
  const double hairline =
      p.x > 0.0 ? 1.600 + std::min(p.x, 0.08) * 1.22 : 1.600 + std::max(p.x, -0.08) * 0.66;
  const double hair = std::clamp((p.z - hairline) / 0.02, 0.0, 1.0);
  const glm::dvec3 out = p - glm::dvec3(0.01, 0.0, 1.63);
  return p + 0.013 * hair * glm::normalize(out);
}

/// A place on a part's surface: u ∈ [0, 1] along it, the angle from front to left; `stretch`: of its rings.
glm::dvec3 surface(const Part& part, double stretch, double u, double angle) {
  const auto last = static_cast<double>(part.rings.size() - 1);
  const auto first = static_cast<int>(std::min(u * last, last - 1.0));
  const std::array<double, 4> weights = catmull_rom(u * last - first);
  Ring ring{};
  for (int n = 0; n < 4; ++n) {
    const int at = std::clamp(first - 1 + n, 0, static_cast<int>(part.rings.size()) - 1);
    const Ring& knot = part.rings[static_cast<std::size_t>(at)];
    const double weight = weights[static_cast<std::size_t>(n)];
    ring.along += weight * knot.along;
    ring.middle += weight * knot.middle;
    ring.left += weight * knot.left;
    ring.front += weight * knot.front;
    ring.back += weight * knot.back;
    ring.aside += weight * knot.aside;
  }
  const double turned = angle - part.crowded * std::sin(angle);
  const double c = std::cos(turned), s = std::sin(turned);
  const double radius =
      stretch *
      std::pow(std::pow(std::abs(c), part.square) + std::pow(std::abs(s), part.square), -1.0 / part.square);
  const double across = ring.middle + radius * c * (c > 0.0 ? ring.front : ring.back);
  const double left = part.left + ring.aside + radius * s * ring.left;
  const glm::dvec3 p =
      part.axis == Axis::kUp ? glm::dvec3(across, left, ring.along) : glm::dvec3(ring.along, left, across);
  return part.material == layouts::kWalkerHead ? with_features(p) : p;
}

std::array<std::uint8_t, 4> skinning_bytes(Joint first, Joint second, double weight, std::uint32_t material) {
  return {static_cast<std::uint8_t>(index_of(first)), static_cast<std::uint8_t>(index_of(second)),
          static_cast<std::uint8_t>(std::lround(255.0 * weight)), static_cast<std::uint8_t>(material)};
}

double smooth_ramp(double t) {
  const double s = std::clamp(t, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

std::array<std::uint8_t, 4> skinning_of(const Part& part, glm::dvec3 p, bool right) {
  // The jacket's skirt goes along with the thigh that it lies on.
  if (!part.is_paired && p.z < kSkirtM) {
    const double weight = 0.9 * smooth_ramp((kSkirtM - p.z) / 0.10) * smooth_ramp(std::abs(p.y) / 0.07);
    return skinning_bytes(kPelvis, on_side(kLeftHip, p.y < 0.0), weight, part.material);
  }
  const double along = part.axis == Axis::kUp ? p.z : p.x;
  const Joining* joining = &part.joinings.front();
  for (const Joining& other : part.joinings) {
    if (along > other.from) joining = &other;
  }
  const double weight = smooth_ramp((along - joining->from) / (joining->to - joining->from));
  const auto joint = [right](Joint of) { return of >= kLeftHip ? on_side(of, right) : of; };
  return skinning_bytes(joint(joining->first), joint(joining->second), weight, part.material);
}

/// Insides of legs and arms see each other and the trunk; what is under the jacket, the chin or the hair sees
/// less.
double openness_of(const Part& part, glm::dvec3 p, glm::dvec3 normal) {
  double hidden = 0.0;
  const double inward = std::max(-normal.y, 0.0);
  if (part.material == layouts::kWalkerTrousers)
    hidden = 0.45 * inward * std::clamp((p.z - 0.2) / 0.5, 0.0, 1.0) + 0.35 * bump(p.z - 0.85, 0.05);
  else if (part.material == layouts::kWalkerShoes)
    hidden = 0.3 * inward + 0.3 * bump(p.x, 0.06);
  else if (part.is_paired && part.left > 0.1)
    hidden = 0.5 * inward * std::clamp((p.z - 0.8) / 0.4, 0.0, 1.0);
  else if (part.material == layouts::kWalkerJacket)
    hidden = 0.40 * std::abs(normal.y) * std::clamp((p.z - 1.0) / 0.15, 0.0, 1.0) *
             std::clamp((1.40 - p.z) / 0.05, 0.0, 1.0);
  else if (p.z < 1.56)
    hidden = 0.35;
  return 1.0 - hidden;
}

void add_part(const Part& part, std::size_t level, bool right, WalkerMesh& mesh) {
  const int rings = part.ring_count[level], segments = part.segment_count[level];
  if (rings == 0) return;
  const double mirror = right ? -1.0 : 1.0;
  const auto add_vertex = [&](glm::dvec3 p, glm::dvec3 normal) {
    const double openness = openness_of(part, p, normal);
    const auto skinning = skinning_of(part, p, right);
    p.y *= mirror;
    normal.y *= mirror;
    mesh.vertices.push_back({glm::vec3(p), static_cast<float>(openness), glm::vec3(normal), skinning});
    return static_cast<std::uint16_t>(mesh.vertices.size() - 1);
  };
  const auto add_triangle = [&](std::uint16_t a, std::uint16_t b, std::uint16_t c) {
    if (right) std::swap(b, c);
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
  };
  // A polygon is as wide as the round that it stands for, on average over all sides (Cauchy).
  const double stretch = std::numbers::pi / (segments * std::sin(std::numbers::pi / segments));
  const auto surface_at = [&](double u, double angle) { return surface(part, stretch, u, angle); };
  const double handed = part.axis == Axis::kUp ? 1.0 : -1.0;
  const auto first = static_cast<std::uint16_t>(mesh.vertices.size());
  for (int ring = 0; ring < rings; ++ring) {
    const double u = static_cast<double>(ring) / (rings - 1);
    for (int segment = 0; segment < segments; ++segment) {
      const double angle = 2.0 * std::numbers::pi * segment / segments, step = 1e-3;
      const double below = std::max(u - step, 0.0), above = std::min(u + step, 1.0);
      const glm::dvec3 along = surface_at(above, angle) - surface_at(below, angle);
      const glm::dvec3 around = surface_at(u, angle + step) - surface_at(u, angle - step);
      add_vertex(surface_at(u, angle), handed * glm::normalize(glm::cross(around, along)));
    }
  }
  const auto at = [&](int ring, int segment) {
    return static_cast<std::uint16_t>(first + ring * segments + segment % segments);
  };
  const auto add_quad = [&](std::uint16_t a, std::uint16_t b, std::uint16_t c, std::uint16_t d) {
    if (handed < 0.0) std::swap(b, d);
    add_triangle(a, b, c);
    add_triangle(a, c, d);
  };
  for (int ring = 0; ring + 1 < rings; ++ring) {
    for (int segment = 0; segment < segments; ++segment)
      add_quad(at(ring, segment), at(ring, segment + 1), at(ring + 1, segment + 1), at(ring + 1, segment));
  }
  // Both ends are closed by fans.
  for (const int ring : {0, rings - 1}) {
    glm::dvec3 middle(0.0);
    for (int segment = 0; segment < segments; ++segment)
      middle += surface_at(ring == 0 ? 0.0 : 1.0, 2.0 * std::numbers::pi * segment / segments) /
                static_cast<double>(segments);
    const double end = ring == 0 ? -1.0 : 1.0;
    const std::uint16_t tip =
        add_vertex(middle, part.axis == Axis::kUp ? glm::dvec3(0.0, 0.0, end) : glm::dvec3(end, 0.0, 0.0));
    for (int segment = 0; segment < segments; ++segment) {
      std::uint16_t a = at(ring, segment), b = at(ring, segment + 1);
      if ((ring == 0) != (handed < 0.0)) std::swap(a, b);
      add_triangle(a, b, tip);
    }
  }
}

}  // namespace

WalkerMesh walker_mesh(std::size_t level) {
  assert(level < kWalkerLevels);
  WalkerMesh mesh;
  for (const Part& part : kParts) {
    add_part(part, level, false, mesh);
    if (part.is_paired) add_part(part, level, true, mesh);
  }
  return mesh;
}

}  // namespace prairie
