#include "bench/scale_ground.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "files/atomic_file.h"
#include "maps/geotiff_output.h"
#include "world/lattice_noise.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLidarTile = "nogp_neon_1m/NEON_D09_NOGP_DP3_350000_5185000_DTM.tif";
constexpr const char* kMadeUpFile = "ground.tif";

constexpr std::uint64_t kSeed = 7;
constexpr int kNodes = 1001;  // a kilometre from the first to the last
// Hills, and on them banks, here gentle and there steep, fitted to the lidar tile's relief.
constexpr double kHillsM = 41.0;
constexpr double kHillWidthM = 550.0;
constexpr double kBanksM = 9.0;
constexpr double kBankWidthM = 50.0;
constexpr double kRoughWidthM = 140.0;

double made_up_height_m(glm::dvec2 p) {
  const double roughness = 0.5 + 0.5 * lattice_noise(kSeed + 20, p / kRoughWidthM + 0.7);
  return kHillsM * layered_noise(kSeed, p / kHillWidthM + 0.37) +
         kBanksM * roughness * layered_noise(kSeed + 10, p / kBankWidthM + 0.11);
}

/// Correlation of the heights with those `lag` nodes further east and north.
double autocorrelation(const GridFrame& frame, std::span<const float> heights_m, double mean_m, int lag) {
  double product = 0.0, square = 0.0;
  for (int row = 0; row + lag < frame.rows; ++row) {
    for (int column = 0; column + lag < frame.columns; ++column) {
      const auto at = [&](int i, int j) {
        return static_cast<double>(heights_m[static_cast<std::size_t>(j) * frame.columns + i]) - mean_m;
      };
      const double here = at(column, row);
      product += here * (at(column + lag, row) + at(column, row + lag));
      square += 2.0 * here * here;
    }
  }
  return product / square;
}

double correlation_length_m(const GridFrame& frame, std::span<const float> heights_m, double mean_m) {
  constexpr int kStep = 4;
  const double target = std::exp(-1.0);
  double last = 1.0;
  for (int lag = kStep; lag < std::min(frame.columns, frame.rows); lag += kStep) {
    const double next = autocorrelation(frame, heights_m, mean_m, lag);
    if (next < target) return frame.spacing_m * (lag - kStep * (target - next) / (last - next));
    last = next;
  }
  return frame.spacing_m * frame.columns;
}

}  // namespace

NodeGrid made_up_prairie() {
  GridFrame frame;
  frame.columns = frame.rows = kNodes;
  std::vector<float> heights_m;
  heights_m.reserve(std::size_t{kNodes} * kNodes);
  for (int row = 0; row < kNodes; ++row) {
    for (int column = 0; column < kNodes; ++column) {
      heights_m.push_back(static_cast<float>(made_up_height_m(glm::dvec2(column, row))));
    }
  }
  return NodeGrid(frame, 1, std::move(heights_m));
}

ScaleGround scale_ground(const fs::path& folder) {
  std::error_code error;
  if (const char* data = std::getenv("PRAIRIE_DATA"); data != nullptr) {
    const fs::path tile = fs::path(data) / kLidarTile;
    if (fs::exists(tile, error)) return {tile, "lidar tile NEON D09 NOGP 350000 5185000"};
  }
  const fs::path file = folder / kMadeUpFile;
  if (!fs::exists(file, error)) write_file_atomically(file, encode_geotiff(made_up_prairie(), nullptr));
  return {file, "made-up ground of the lidar tile's relief"};
}

Relief relief_of(const NodeGrid& heights_m) {
  const GridFrame& frame = heights_m.frame();
  const std::span<const float> nodes = heights_m.values();
  double sum = 0.0, sum_of_squares = 0.0;
  for (const float node : nodes) sum += static_cast<double>(node);
  const double mean_m = sum / static_cast<double>(nodes.size());
  for (const float node : nodes) sum_of_squares += std::pow(static_cast<double>(node) - mean_m, 2.0);

  std::vector<double> slopes;
  for (int row = 1; row + 1 < frame.rows; ++row) {
    for (int column = 1; column + 1 < frame.columns; ++column) {
      const std::size_t node = static_cast<std::size_t>(row) * frame.columns + column;
      const double east = static_cast<double>(nodes[node + 1] - nodes[node - 1]);
      const double north = static_cast<double>(nodes[node + frame.columns] - nodes[node - frame.columns]);
      slopes.push_back(std::hypot(east, north) / (2.0 * frame.spacing_m));
    }
  }
  const auto slope_deg = [&](double share) {
    const auto nth = slopes.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(slopes.size()));
    std::ranges::nth_element(slopes, nth);
    return std::atan(*nth) * 180.0 / std::numbers::pi;
  };
  Relief relief;
  relief.deviation_m = std::sqrt(sum_of_squares / static_cast<double>(nodes.size()));
  relief.median_slope_deg = slope_deg(0.5);
  relief.steep_slope_deg = slope_deg(0.99);
  relief.correlation_m = correlation_length_m(frame, nodes, mean_m);
  return relief;
}

}  // namespace prairie
