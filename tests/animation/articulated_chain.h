// The reference for moving blades: Featherstone's articulated-body algorithm (Rigid Body Dynamics Algorithms,
// 2008, ch. 7) in double for the chain of shaders/kernels/chain.glsl: rods with spherical joints and springs,
// weight of the segments above, Coriolis and centrifugal forces, torsion. Units: half a segment l, its mass
// m, and √(l/g); so that gravity is 1 and a spring constant is κ = k/(m g l).
#pragma once

#include <array>
#include <glm/ext/quaternion_double.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace prairie {

class ArticulatedChain {
 public:
  static constexpr int kSegments = 4;
  /// A chain that is relaxed as an arc: its foot along `foot`, from there turning about `axis` ⟂ foot by
  /// `turning` altogether.
  ArticulatedChain(glm::dvec3 foot, glm::dvec3 axis, double turning, double stiffness);

  /// Friction of a medium at rest: a force of −`medium` m v, and the like moment, on each segment.
  double medium = 0.0;

  void step(double dt);
  /// Lets a chain in a thick medium come to rest.
  void settle();

  /// Turns all segments from their place now; rates become zero.
  void turn(const std::array<glm::dvec3, kSegments>& rotations);

  std::array<glm::dvec3, kSegments> directions() const;
  /// In half segments.
  glm::dvec3 tip() const;
  double energy() const;
  double fastest() const;

 private:
  struct State {
    std::array<glm::dquat, kSegments> frame;  // turns (0, 0, 1) into a segment's direction
    std::array<glm::dvec3, kSegments> rate;   // of segments, in world axes
  };
  std::array<glm::dvec3, kSegments> accelerations(const State& state) const;
  State moved(const State& from, const State& slope_at, const std::array<glm::dvec3, kSegments>& acceleration,
              double dt) const;
  glm::dvec3 spring_angle(const State& state, int segment) const;

  double stiffness_;
  std::array<glm::dquat, kSegments> relaxed_;  // from the segment below; the lowest: from the world
  State state_;
};

}  // namespace prairie
