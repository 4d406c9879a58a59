#include "render/things/walker_pass.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "lod/frustum.h"
#include "render/gl/packed_meshes.h"
#include "render/gl/shader_program.h"
#include "shaders/kernels/kernels.h"
#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

static_assert(layouts::kWalkerBoneRows == 3 * kJointCount);

/// Heights down to which the first levels are drawn: their triangles are then some pixels large.
constexpr std::array<double, kWalkerLevels - 1> kLeastHeightPx{200.0, 60.0};

// Linear.
constexpr std::array<glm::vec3, 5> kSkins{{{0.46f, 0.285f, 0.205f},
                                           {0.39f, 0.23f, 0.16f},
                                           {0.29f, 0.16f, 0.105f},
                                           {0.17f, 0.088f, 0.055f},
                                           {0.085f, 0.045f, 0.030f}}};
constexpr std::array<glm::vec3, 6> kHairs{{{0.012f, 0.010f, 0.009f},
                                           {0.020f, 0.014f, 0.010f},
                                           {0.030f, 0.018f, 0.011f},
                                           {0.17f, 0.165f, 0.16f},
                                           {0.070f, 0.041f, 0.021f},
                                           {0.20f, 0.135f, 0.065f}}};
constexpr std::size_t kLightSkins = 2, kDarkHairs = 4;  // dark-skinned people have one of the first of these
constexpr std::array<glm::vec3, 8> kJackets{{{0.115f, 0.024f, 0.021f},
                                             {0.032f, 0.050f, 0.088f},
                                             {0.050f, 0.060f, 0.030f},
                                             {0.155f, 0.108f, 0.045f},
                                             {0.038f, 0.039f, 0.042f},
                                             {0.210f, 0.190f, 0.155f},
                                             {0.034f, 0.072f, 0.074f},
                                             {0.088f, 0.046f, 0.028f}}};
constexpr std::array<glm::vec3, 5> kTrousers{{{0.028f, 0.036f, 0.058f},
                                              {0.030f, 0.029f, 0.029f},
                                              {0.105f, 0.080f, 0.053f},
                                              {0.050f, 0.048f, 0.039f},
                                              {0.060f, 0.068f, 0.084f}}};
constexpr std::array<glm::vec3, 3> kShoes{
    {{0.045f, 0.026f, 0.015f}, {0.018f, 0.018f, 0.018f}, {0.10f, 0.085f, 0.07f}}};

constexpr std::array<VertexAttribute, 4> kVertexAttributes{{
    {3, GL_FLOAT, offsetof(WalkerVertex, place_m)},
    {3, GL_FLOAT, offsetof(WalkerVertex, facing)},
    {4, GL_UNSIGNED_BYTE, offsetof(WalkerVertex, skinning), Numbers::kIntegers},
    {1, GL_FLOAT, offsetof(WalkerVertex, openness)},
}};

std::array<WalkerMesh, kWalkerLevels> all_levels() {
  std::array<WalkerMesh, kWalkerLevels> levels;
  for (std::size_t level = 0; level < kWalkerLevels; ++level) levels[level] = walker_mesh(level);
  return levels;
}

/// A number below `count`, by the walker and by what is chosen.
std::size_t choice(std::uint32_t seed, std::uint32_t what, std::size_t count) {
  return Kernels{}.hash_u32(Kernels{}.hash_u32(seed) + what) % count;
}

WalkerParams params_of(const WalkerLook& walker, glm::dvec3 eye_m, float sward_height_m) {
  WalkerParams params{};
  const double scale = walker.height_m / kFigureHeightM;
  for (std::size_t n = 0; n < kJointCount; ++n) {
    const JointFrame& joint = walker.pose[n];
    const glm::dmat3 scene_from_figure = scale * joint.axes;
    const glm::dvec3 shift_m = joint.place_m - scene_from_figure * kRestSkeleton[n].place_m - eye_m;
    for (int row = 0; row < 3; ++row) {
      params.bones[3 * n + static_cast<std::size_t>(row)] = glm::vec4(glm::dvec4(
          scene_from_figure[0][row], scene_from_figure[1][row], scene_from_figure[2][row], shift_m[row]));
    }
  }
  const double lower_ankle_m = std::min(walker.pose[index_of(Joint::kLeftAnkle)].place_m.z,
                                        walker.pose[index_of(Joint::kRightAnkle)].place_m.z);
  params.ground_from_eye_m = static_cast<float>(lower_ankle_m - scale * kAnkleHeightM - eye_m.z);
  params.in_sward_m = std::max(0.9f * sward_height_m, 0.15f);
  params.seed = walker.seed;
  const std::size_t skin = choice(walker.seed, 1, kSkins.size());
  params.skin = kSkins[skin];
  params.hair = kHairs[choice(walker.seed, 2, skin < kLightSkins ? kHairs.size() : kDarkHairs)];
  params.jacket = kJackets[choice(walker.seed, 3, kJackets.size())];
  params.trousers = kTrousers[choice(walker.seed, 4, kTrousers.size())];
  params.shoes = kShoes[choice(walker.seed, 5, kShoes.size())];
  return params;
}

std::size_t level_of(const WalkerLook& walker, const Camera& camera) {
  const double distance_m = glm::distance(walker.pose[0].place_m, camera.eye_m);
  const double height_px = walker.height_m / camera.pixel_m_at(std::max(distance_m, 1e-3));
  std::size_t level = 0;
  while (level < kLeastHeightPx.size() && height_px < kLeastHeightPx[level]) ++level;
  return level;
}

AlignedBox box_of(const WalkerLook& walker) {
  const glm::dvec3 reach_m(0.75 * walker.height_m);
  return {walker.pose[0].place_m - reach_m, walker.pose[0].place_m + reach_m};
}

}  // namespace

struct WalkerPass::Device {
  explicit Device(const std::filesystem::path& shader_folder)
      : program(make_program(shader_folder, {"pass/walker.vert", "pass/walker.frag"})) {}

  GlProgram program;
  PackedMeshes meshes{std::span<const WalkerMesh>(all_levels()), kVertexAttributes, "walkers"};
};

WalkerPass::WalkerPass(std::filesystem::path shader_folder) : shader_folder_(std::move(shader_folder)) {}

WalkerPass::~WalkerPass() = default;

bool WalkerPass::prepare(StreamBuffer& stream, std::span<const WalkerLook> walkers, const Camera& camera,
                         float sward_height_m) {
  counts_ = {};
  triangles_drawn_ = 0;
  if (walkers.empty()) return false;
  if (!device_) device_ = std::make_unique<Device>(shader_folder_);
  const Frustum frustum(camera);
  std::array<std::vector<WalkerParams>, kWalkerLevels> by_level;
  for (const WalkerLook& walker : walkers) {
    if (frustum.may_see(box_of(walker)))
      by_level[level_of(walker, camera)].push_back(params_of(walker, camera.eye_m, sward_height_m));
  }
  std::vector<WalkerParams> table;
  for (std::size_t level = 0; level < kWalkerLevels; ++level) {
    counts_[level] = static_cast<std::uint32_t>(by_level[level].size());
    table.insert(table.end(), by_level[level].begin(), by_level[level].end());
  }
  if (table.empty()) return false;
  table_ = stream.write(table.data(), table.size() * sizeof(WalkerParams));
  return true;
}

void WalkerPass::draw() {
  triangles_drawn_ = 0;
  std::uint32_t first = 0;
  for (std::size_t level = 0; level < kWalkerLevels; ++level) {
    const std::uint32_t count = counts_[level];
    if (count == 0) continue;
    const GLuint program = device_->program.get();
    glUseProgram(program);
    glProgramUniform1ui(program, layouts::kFirstThing, first);
    bind_storage(layouts::kThingBuffer, table_);
    triangles_drawn_ += device_->meshes.draw(level, count);
    first += count;
  }
}

}  // namespace prairie
