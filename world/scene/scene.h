// A scene as its file says it (scene.toml), before any map is opened: plain data, checked, with defaults
// filled in.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agents/crowd_spec.h"
#include "agents/mover.h"
#include "agents/obstacle.h"
#include "animation/condition.h"
#include "animation/tread_node.h"
#include "animation/wind_primitives.h"
#include "files/error.h"
#include "generator/species.h"
#include "lod/quality.h"
#include "maps/map_file.h"

namespace prairie {

/// A camera as a person gives it. Yaw 0 looks north (+y), clockwise; pitch up is positive.
struct CameraSpec {
  std::string name;
  glm::dvec2 position_m{0.0};
  double z_m = 1.7;
  bool z_above_ground = true;
  double yaw_deg = 0.0;
  double pitch_deg = 0.0;
  double fov_deg = 60.0;  // vertical
};

/// How blades of a species answer to wind and feet (docs/chains.md).
struct BladeMotionSpec {
  double damping_ratio = 0.2;
  double drag_coefficient = 0.2;  // of a blade in wind of 1 m/s, as a strip across it
};

struct SpeciesSpec {
  Species species;
  BladeMotionSpec motion;
  std::optional<MapSpec> density;  // without a map the density is uniform:
  double uniform_density_per_m2 = 1000.0;
};

struct SunSpec {
  double azimuth_deg = 150.0;  // clockwise from north
  double elevation_deg = 38.0;
  glm::vec3 color{1.0f, 0.93f, 0.80f};  // linear, relative
  double intensity = 3.2;
  double sky_intensity = 1.0;
  double haze_per_m = 0.0006;  // fog density b of RG "Fog"
};

/// The wind (animation/wind.h). Headings are those towards which it blows, clockwise from north.
struct WindSpec {
  double speed_m_per_s = 0.0;
  double heading_deg = 90.0;
  double turbulence = 1.0;  // factor on the noise; 0: none, as with a file that is all there is
  std::optional<std::filesystem::path> file;  // a measured series in place of speed and heading
  std::optional<glm::dvec2> place_m;          // where it was measured; none: in the middle of the ground
  std::vector<WindPrimitive> primitives;
};

/// Something that moves over the grass and presses it down.
struct MoverSpec {
  std::string name;
  MoverPath path;
};

/// A place that walkers go to.
struct GoalSpec {
  std::string name;
  Goal goal;
};

struct LodSpec {
  Quality quality = Quality::kMedium;
  double blade_distance_m = 120.0;  // beyond it only the flat tier is drawn
};

/// What a square metre is that densities count blades on.
enum class DensityPer { kMap, kSurface };

struct Scene {
  std::filesystem::path folder;
  std::uint64_t seed = 1;
  double tile_m = 4.0;
  DensityPer density_per = DensityPer::kMap;
  std::optional<MapSpec> height;  // none: level ground
  glm::dvec2 extent_m{0.0};       // of level ground without a map; (0, 0) with one
  std::vector<SpeciesSpec> species;
  std::optional<MapSpec> blade_height;  // factor on the length of blades
  std::optional<MapSpec> bend;          // factor on their curvature
  std::optional<MapSpec> color;         // factor on their colour (and the ground's)
  std::vector<CameraSpec> cameras;
  SunSpec sun;
  LodSpec lod;
  std::optional<WindSpec> wind;  // none: calm air
  std::vector<Condition> conditions;
  TreadSettings treading;
  std::vector<MoverSpec> movers;
  StandingThings standing;
  std::vector<GoalSpec> goals;
  std::vector<WalkerGroup> walkers;
  glm::vec3 soil_color{0.11f, 0.08f, 0.05f};  // linear albedo of bare ground
};

/// A fault in an override, not in the scene's file: the command line's business.
struct BadOverride : BadInput {
  using BadInput::BadInput;
};

inline constexpr int kSceneVersion = 1;  // of the file's form
inline constexpr const char* kSceneFileName = "scene.toml";
inline constexpr const char* kWindFileField = "wind.file";
inline constexpr double kMaxDensityPerM2 = 1e5;
inline constexpr int kMaxSpecies = 16;
inline constexpr std::size_t kMaxWindPrimitives = 64;
inline constexpr std::size_t kMaxConditions = 64;
inline constexpr std::size_t kMaxMovers = 1000;
inline constexpr std::size_t kMaxPathPoints = 1000;  // of a mover, or of a wall's ring
inline constexpr std::size_t kMaxObstacles = 10'000;
inline constexpr std::size_t kMaxWalls = 1000;

/// Reads DIR/scene.toml; `overrides` are "key=value" with dotted keys ("lod.quality=high",
/// "species.0.height_m=0.5" or by name "species.fescue.height_m=0.5") and TOML values, or plain text. Every
/// key is known, of the right type and in range, or BadInput (for an override, BadOverride) says which is
/// not, what it found, and (for a typing error) which key was meant. Maps are not opened.
Scene read_scene(const std::filesystem::path& folder, const std::vector<std::string>& overrides);

/// The same for a scene file's text; `folder` is where its maps' relative paths start.
Scene parse_scene(std::string_view text, const std::filesystem::path& folder,
                  const std::vector<std::string>& overrides);

}  // namespace prairie
