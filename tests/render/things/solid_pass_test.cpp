// Solid things cover the pixels that they should: the outline of a smooth sphere against geometry, that of a
// boulder within the sphere, and what stands behind a ridge is hidden by it. What is expected is traced ray
// by ray.
#include "render/things/solid_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "render/frame/renderer.h"
#include "render/gl/render_target.h"
#include "render/things/shapes/solid_mesh.h"
#include "tests/render/headless_test.h"
#include "tests/render/test_world.h"
#include "tests/render/things/covered_pixels.h"

namespace prairie {
namespace {

constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// The ray through the middle of a pixel, rows from the top; a unit vector.
glm::dvec3 ray_of(const Camera& camera, int column, int row) {
  const double pixel = camera.pixel_m();
  const double x = (column + 0.5 - 0.5 * camera.size_px.x) * pixel;
  const double y = (0.5 * camera.size_px.y - row - 0.5) * pixel;
  return glm::normalize(camera.forward() + x * camera.right() + y * camera.up());
}

double distance_to_sphere_m(const Camera& camera, glm::dvec3 ray, glm::dvec3 centre_m, double radius_m) {
  const glm::dvec3 to_centre = centre_m - camera.eye_m;
  const double along = glm::dot(to_centre, ray);
  const double beside2 = glm::dot(to_centre, to_centre) - along * along;
  if (along < 0.0 || beside2 > radius_m * radius_m) return kNoHit;
  return along - std::sqrt(radius_m * radius_m - beside2);
}

double distance_to_ground_m(const Camera& camera, glm::dvec3 ray, const HeightField& ground) {
  for (double along = 0.0; along < 60.0; along += 0.02) {
    const glm::dvec3 place = camera.eye_m + along * ray;
    if (place.z < static_cast<double>(ground.height_m(glm::dvec2(place)))) return along;
  }
  return kNoHit;
}

class SolidPassTest : public HeadlessTest {
 protected:
  /// Which pixels a solid on its own covers, rows from the top.
  std::vector<bool> covered(const World& world, const Camera& camera, const DrawnSolid& solid) {
    SolidPass pass(PRAIRIE_TEST_SHADERS);
    return covered_pixels(world, camera, SolidPass::kState, [&](StreamBuffer& stream) {
      pass.prepare(stream, {&solid, 1}, camera);
      pass.draw();
    });
  }

  static Camera camera() {
    Camera camera;
    camera.eye_m = {3.0, 4.0, 2.0};
    camera.yaw_rad = 0.7;
    camera.pitch_rad = -0.2;
    camera.size_px = {320, 240};
    return camera;
  }

  TemporaryFolder folder_;
};

TEST(SphereMesh, AllTrianglesFaceOutward) {
  for (const int subdivisions : {0, 1, 4}) {
    const SolidMesh mesh = sphere_mesh(subdivisions);
    for (std::size_t n = 0; n < mesh.indices.size(); n += 3) {
      const glm::vec3 a = mesh.vertices[mesh.indices[n]].place, b = mesh.vertices[mesh.indices[n + 1]].place,
                      c = mesh.vertices[mesh.indices[n + 2]].place;
      ASSERT_GT(glm::dot(glm::cross(b - a, c - a), a), 0.0f) << "those that face away are not drawn";
    }
  }
}

TEST_F(SolidPassTest, SmoothSphereHasItsOutline) {
  const World world = open_world(dark_ground_scene(folder_, false));
  const Camera camera = SolidPassTest::camera();
  DrawnSolid sphere;
  sphere.half_size_m = glm::vec3(0.7f);
  sphere.centre_m = camera.eye_m + 3.0 * camera.forward();
  const std::vector<bool> pixels = covered(world, camera, sphere);
  const double radius_px = std::tan(std::asin(0.7 / 3.0)) / camera.pixel_m();
  const double area = std::numbers::pi * radius_px * radius_px;
  EXPECT_NEAR(static_cast<double>(std::ranges::count(pixels, true)), area, 0.02 * area);

  sphere.centre_m += 0.8 * camera.right() - 0.5 * camera.up();
  const std::vector<bool> aside = covered(world, camera, sphere);
  int expected = 0, differing = 0;
  for (int n = 0; n < static_cast<int>(aside.size()); ++n) {
    const glm::dvec3 ray = ray_of(camera, n % camera.size_px.x, n / camera.size_px.x);
    const bool hit = distance_to_sphere_m(camera, ray, sphere.centre_m, 0.7) < kNoHit;
    expected += hit;
    differing += hit != aside[static_cast<std::size_t>(n)];
  }
  EXPECT_LT(differing, 0.02 * expected);
}

TEST_F(SolidPassTest, BoulderStaysWithinItsSphere) {
  const World world = open_world(dark_ground_scene(folder_, false));
  const Camera camera = SolidPassTest::camera();
  constexpr double kRadiusM = 0.7, kRoughness = 0.06;
  DrawnSolid stone;
  stone.half_size_m = glm::vec3(static_cast<float>(kRadiusM));
  stone.roughness_of_outline = static_cast<float>(kRoughness);
  stone.centre_m = camera.eye_m + 3.0 * camera.forward();
  int within = 0, outside = 0, dented = 0;
  for (const std::uint32_t seed : {0u, 1u, 2u, 3u}) {
    stone.seed = seed;
    const std::vector<bool> pixels = covered(world, camera, stone);
    for (int n = 0; n < static_cast<int>(pixels.size()); ++n) {
      const glm::dvec3 ray = ray_of(camera, n % camera.size_px.x, n / camera.size_px.x);
      const bool shown = pixels[static_cast<std::size_t>(n)];
      const bool in_outer = distance_to_sphere_m(camera, ray, stone.centre_m, kRadiusM) < kNoHit;
      // The mesh's flat triangles lie a little under the surface.
      const bool in_inner =
          distance_to_sphere_m(camera, ray, stone.centre_m, kRadiusM * (1.0 - kRoughness - 0.004)) < kNoHit;
      within += in_inner && !shown;
      outside += shown && !in_outer;
      dented += in_outer && !shown;
    }
  }
  EXPECT_EQ(within, 0);
  EXPECT_EQ(outside, 0);
  EXPECT_GT(dented, 100) << "a stone, not a sphere";
}

TEST_F(SolidPassTest, NothingIsMadeForNothing) {
  StreamBuffer stream(std::size_t{1} << 10);
  SolidPass pass("/nowhere");
  pass.prepare(stream, {}, Camera{});
  pass.draw();
  EXPECT_EQ(pass.triangles_drawn(), 0u);
}

TEST_F(SolidPassTest, GroundHidesWhatStandsBehindIt) {
  Scene scene = dark_ground_scene(folder_, false);
  scene.height = write_map(folder_, "ridge.tif", 32.0, 1.0, [](glm::dvec2 p) {
    const double from_ridge = (p.y - 7.0) / 1.6;
    return 1.1 * std::exp(-from_ridge * from_ridge) * (p.x < 4.0 ? 1.0 : 0.0);
  });
  const World bare = open_world(scene);
  MoverPath path;
  path.radius_m = 1.0;
  path.path_m = {{3.0, 2.0}, {12.0, 2.0}};
  scene.movers.push_back({"stone", path});
  const World world = open_world(scene);
  const glm::dvec3 centre_m = world.movers().front().place(world.meadow().ground, 0.0).centre_m;
  Camera camera;
  camera.eye_m = {4.0, 15.0, 1.9};
  camera.yaw_rad = std::numbers::pi;
  camera.pitch_rad = -0.1;
  camera.size_px = {480, 360};
  const FrameOptions options{Tier::kFlat, false};
  const Picture without = Renderer(bare, PRAIRIE_TEST_SHADERS).render(camera, options, 1);
  const Picture with = Renderer(world, PRAIRIE_TEST_SHADERS).render(camera, options, 1);

  int seen = 0, hidden = 0, wrong = 0;
  for (std::size_t n = 0; n < with.cover.size(); ++n) {
    const int column = static_cast<int>(n) % camera.size_px.x, row = static_cast<int>(n) / camera.size_px.x;
    const glm::dvec3 ray = ray_of(camera, column, row);
    const double sphere_m = distance_to_sphere_m(camera, ray, centre_m, 1.0);
    const double ground_m =
        sphere_m < kNoHit ? distance_to_ground_m(camera, ray, world.meadow().ground) : 0.0;
    const double core_m = distance_to_sphere_m(camera, ray, centre_m, 0.92);
    const bool differs = with.linear_rgb[3 * n + 1] != without.linear_rgb[3 * n + 1];
    const bool must_show = core_m + 0.1 < ground_m;
    const bool must_hide = sphere_m == kNoHit || ground_m + 0.1 < sphere_m;
    seen += must_show;
    hidden += sphere_m < kNoHit && must_hide;
    wrong += must_show ? !differs : must_hide && differs;
  }
  EXPECT_GT(seen, 100);
  EXPECT_GT(hidden, 100);
  // The mesh of the ground, quads of half a metre, cuts up to 5 cm off the ridge: two rows of pixels along 80
  // columns.
  std::printf("%d pixels seen, %d hidden, %d wrong\n", seen, hidden, wrong);
  EXPECT_LE(wrong, 60);
}

}  // namespace
}  // namespace prairie
