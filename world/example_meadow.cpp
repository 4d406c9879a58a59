#include "world/example_meadow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/camera_placement.h"
#include "world/lattice_noise.h"

namespace prairie {
namespace {

constexpr double kSideM = 192.0;
constexpr double kGroundSpacingM = 2.0;
constexpr double kDensitySpacingM = 0.5;
constexpr double kHeightFactorSpacingM = 1.0;
constexpr double kFescueMaxPerM2 = 1700.0;
constexpr double kOatgrassMaxPerM2 = 400.0;
constexpr double kHeightFactorMax = 1.6;

constexpr double kPathHalfWidthM = 0.75;
constexpr double kPathPhase = 0.75;  // before the viewer it swings to the right, then back across the view
constexpr double kPathStepM = 0.25;
constexpr double kClearingRadiusM = 7.0;
constexpr double kClearingFromPathM = 17.0;
constexpr double kClearingNorthM = 104.0;
constexpr double kHollowNorthM = 76.0;
constexpr double kViewerNorthM = 30.0;
constexpr double kViewerFromPathM = 3.0;
constexpr double kKnollM = 1.6;
constexpr double kKnollWidthM = 24.0;

// Each feature has its own stretch of seeds.
enum Feature : std::uint64_t { kHills = 10, kBend = 20, kWarp = 30, kVigour = 40, kDrift = 50, kFringe = 60 };

double smoothed(double low, double high, double value) {
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Parabolic arches, to and fro with period 1: a sine in plain arithmetic.
double arch_wave(double t) {
  const double turn = t - std::floor(t);
  return turn < 0.5 ? 16.0 * turn * (0.5 - turn) : -16.0 * (turn - 0.5) * (1.0 - turn);
}

class Plan {
 public:
  explicit Plan(std::uint64_t seed)
      : seed_(seed * 0x9e3779b97f4a7c15ull),
        phase_(kPathPhase + 0.04 * lattice_noise(seed_ + kBend, {-7.0, -7.0})) {
    for (double y = -kPathMarginM; y <= kSideM + kPathMarginM; y += kPathStepM)
      path_.push_back({path_east_m(y), y});
    viewer_m_ = {path_east_m(kViewerNorthM) + kViewerFromPathM, kViewerNorthM};
    clearing_m_ = {path_east_m(kClearingNorthM) - kClearingFromPathM, kClearingNorthM};
  }

  // A hollow before the viewer, so that the far slope turns towards the eye, a knoll to look down from, and
  // gentle hills on top.
  double ground_m(glm::dvec2 p) const {
    const glm::dvec2 from_hollow = (p - glm::dvec2(0.5 * kSideM, kHollowNorthM)) / (0.5 * kSideM);
    const double hollow_m = 1.8 * from_hollow.x * from_hollow.x + 4.6 * from_hollow.y * from_hollow.y;
    const glm::dvec2 from_viewer = (p - viewer_m_) / kKnollWidthM;
    const double fall = 1.0 + from_viewer.x * from_viewer.x + from_viewer.y * from_viewer.y;
    return hollow_m + kKnollM / (fall * fall) + 2.0 * layered_noise(seed_ + kHills, p / 58.0 + 0.37);
  }

  glm::dvec2 viewer_m() const { return viewer_m_; }

  double path_east_m(double north_m) const {
    const double wander = lattice_noise(seed_ + kBend, {north_m / 38.0, 0.5});
    return 0.5 * kSideM + 11.0 * arch_wave(north_m / 84.0 + phase_) + 5.0 * wander;
  }

  double path_distance_m(glm::dvec2 p) const {
    const auto middle = static_cast<int>((p.y + kPathMarginM) / kPathStepM);
    const auto reach = static_cast<int>(kPathMarginM / kPathStepM);
    const int last = std::min(middle + reach, static_cast<int>(path_.size()) - 1);
    double nearest2_m2 = kPathMarginM * kPathMarginM;
    for (int k = std::max(0, middle - reach); k <= last; ++k) {
      const glm::dvec2 d = path_[static_cast<std::size_t>(k)] - p;
      nearest2_m2 = std::min(nearest2_m2, d.x * d.x + d.y * d.y);
    }
    return std::sqrt(nearest2_m2);
  }

  double clearing_distance_m(glm::dvec2 p) const {
    const glm::dvec2 d = p - clearing_m_;
    const double fringe_m = 0.8 * lattice_noise(seed_ + kFringe, p / 2.2);
    return std::sqrt(d.x * d.x + d.y * d.y) - kClearingRadiusM + fringe_m;
  }

  // 0 where feet keep the soil bare, 1 beside the path.
  double untrodden(glm::dvec2 p) const {
    const double fringe_m = 0.22 * lattice_noise(seed_ + kFringe + 5, p / 1.1);
    return smoothed(0.6 * kPathHalfWidthM, 1.5 * kPathHalfWidthM, path_distance_m(p) + fringe_m);
  }

  // 0 in the clearing, 1 outside.
  double unmown(glm::dvec2 p) const { return smoothed(-0.6, 2.2, clearing_distance_m(p)); }

  double drift(glm::dvec2 p) const {
    const glm::dvec2 warp{lattice_noise(seed_ + kWarp, p / 14.0), lattice_noise(seed_ + kWarp + 1, p / 14.0)};
    return smoothed(-0.10, 0.42, layered_noise(seed_ + kDrift, (p + 5.0 * warp) / 29.0 + 11.2));
  }

  double fescue_per_m2(glm::dvec2 p) const {
    const double vigour = 1.0 + 0.30 * layered_noise(seed_ + kVigour, p / 9.0);
    const double thinned_by_mowing = 0.3 + 0.7 * unmown(p);
    return 1350.0 * vigour * untrodden(p) * thinned_by_mowing * (1.0 - 0.35 * drift(p) * unmown(p));
  }

  double oatgrass_per_m2(glm::dvec2 p) const {
    const double patchy = 0.75 + 0.35 * layered_noise(seed_ + kVigour + 5, p / 5.0);
    return kOatgrassMaxPerM2 * drift(p) * patchy * unmown(p) * smoothed(0.8, 3.5, path_distance_m(p));
  }

  double height_factor(glm::dvec2 p) const {
    const double vigour = 1.0 + 0.22 * layered_noise(seed_ + kVigour, p / 9.0) +
                          0.18 * lattice_noise(seed_ + kVigour + 9, p / 31.0);
    const double beside_path = 0.5 + 0.5 * smoothed(0.6, 3.0, path_distance_m(p));
    const double inside_clearing = 0.35 + 0.65 * smoothed(-1.0, 3.0, clearing_distance_m(p));
    return vigour * beside_path * inside_clearing;
  }

 private:
  static constexpr double kPathMarginM = 8.0;

  std::uint64_t seed_;
  double phase_;
  std::vector<glm::dvec2> path_;
  glm::dvec2 viewer_m_{0.0};
  glm::dvec2 clearing_m_{0.0};
};

NodeGrid make_ground(const Plan& plan) {
  GridFrame frame;
  frame.columns = frame.rows = static_cast<int>(kSideM / kGroundSpacingM) + 1;
  frame.spacing_m = kGroundSpacingM;
  std::vector<float> heights_m;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) {
      // Whole centimetres: no instrument knows more, and the file is half the size.
      const double height_m = plan.ground_m(frame.spacing_m * glm::dvec2(column, row));
      heights_m.push_back(static_cast<float>(std::floor(100.0 * height_m + 0.5) / 100.0));
    }
  }
  return NodeGrid(frame, 1, std::move(heights_m));
}

template <typename Feature>
GreyMap make_map(double spacing_m, double max, const Feature& feature) {
  GreyMap map;
  map.columns = map.rows = static_cast<int>(kSideM / spacing_m) + 1;
  map.spacing_m = spacing_m;
  map.max = max;
  for (int row = map.rows - 1; row >= 0; --row) {
    for (int column = 0; column < map.columns; ++column) {
      const double share = std::clamp(feature(spacing_m * glm::dvec2(column, row)) / max, 0.0, 1.0);
      map.values.push_back(static_cast<std::uint8_t>(255.0 * share + 0.5));
    }
  }
  return map;
}

double to_tenths(double value) {
  return std::floor(10.0 * value + 0.5) / 10.0;
}

class Viewer {
 public:
  Viewer(const Plan& plan, const NodeGrid& ground_m) : plan_(plan) { meadow_.ground = HeightField(ground_m); }

  CameraSpec camera(const char* name, glm::dvec2 from_m, glm::dvec2 at_m, double eye_height_m) const {
    const double kDegPerRad = 180.0 / std::numbers::pi;
    const glm::dvec2 ahead_m = at_m - from_m;
    CameraSpec camera;
    camera.name = name;
    camera.position_m = {to_tenths(from_m.x), to_tenths(from_m.y)};
    camera.z_m = eye_height_m;
    camera.yaw_deg = std::round(std::atan2(ahead_m.x, ahead_m.y) * kDegPerRad);
    const double distance_m = std::sqrt(ahead_m.x * ahead_m.x + ahead_m.y * ahead_m.y);
    camera.pitch_deg =
        std::round(pitch_to_ground_deg(meadow_, camera.position_m, camera.yaw_deg, eye_height_m, distance_m));
    return camera;
  }

  // The place nearest to `wanted_m` along the east-west line where grass stands around the feet.
  glm::dvec2 standing_place(glm::dvec2 wanted_m) const {
    for (double aside_m = 0.0; aside_m < 20.0; aside_m += 0.5) {
      for (const double sign : {1.0, -1.0}) {
        const glm::dvec2 p = wanted_m + glm::dvec2(sign * aside_m, 0.0);
        if (plan_.unmown(p) > 0.99 && plan_.path_distance_m(p) > 2.2) return p;
      }
    }
    return wanted_m;
  }

  glm::dvec2 highest_place_in_the_south() const {
    glm::dvec2 best_m{0.0};
    double highest_m = -1e9;
    for (double x = 0.2 * kSideM; x <= 0.8 * kSideM; x += 4.0) {
      const glm::dvec2 p{x, 10.0};
      const double height_m = plan_.ground_m(p);
      if (height_m > highest_m) {
        highest_m = height_m;
        best_m = p;
      }
    }
    return best_m;
  }

 private:
  const Plan& plan_;
  Meadow meadow_;
};

std::vector<CameraSpec> make_cameras(const Plan& plan, const NodeGrid& ground_m) {
  const Viewer viewer(plan, ground_m);
  const auto on_path = [&](double north_m) { return glm::dvec2(plan.path_east_m(north_m), north_m); };
  const glm::dvec2 viewer_m = viewer.standing_place(plan.viewer_m());
  const glm::dvec2 kneeling_m = viewer.standing_place(viewer_m + glm::dvec2(9.0, 14.0));
  const glm::dvec2 rise_m = viewer.highest_place_in_the_south();
  const glm::dvec2 middle_m{0.5 * kSideM, 0.5 * kSideM};

  std::vector<CameraSpec> cameras;
  cameras.push_back(viewer.camera("default", viewer_m, on_path(kViewerNorthM + 26.0), kEyeHeightM));
  cameras.push_back(viewer.camera("close", kneeling_m, kneeling_m + glm::dvec2(-1.0, 2.4), 0.45));
  cameras.push_back(viewer.camera("wide", rise_m, on_path(0.4 * kSideM), 6.0));
  CameraSpec top;
  top.name = "top";
  top.position_m = middle_m;
  top.z_m = 90.0;
  top.pitch_deg = -90.0;
  cameras.push_back(top);
  return cameras;
}

}  // namespace

ExampleMeadow make_example_meadow(std::uint64_t seed) {
  const Plan plan(seed);
  ExampleMeadow meadow;
  meadow.ground_m = make_ground(plan);
  meadow.fescue_per_m2 =
      make_map(kDensitySpacingM, kFescueMaxPerM2, [&](glm::dvec2 p) { return plan.fescue_per_m2(p); });
  meadow.oatgrass_per_m2 =
      make_map(kDensitySpacingM, kOatgrassMaxPerM2, [&](glm::dvec2 p) { return plan.oatgrass_per_m2(p); });
  meadow.blade_height =
      make_map(kHeightFactorSpacingM, kHeightFactorMax, [&](glm::dvec2 p) { return plan.height_factor(p); });
  meadow.cameras = make_cameras(plan, meadow.ground_m);
  return meadow;
}

}  // namespace prairie
