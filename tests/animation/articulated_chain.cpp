#include "articulated_chain.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

namespace prairie {
namespace {

using Vec = glm::dvec3;
using Mat = glm::dmat3;

// Of a rod of mass 1 and length 2, and what little a blade resists being spun about its own axis.
constexpr double kAcross = 1.0 / 3.0;
constexpr double kAxial = 0.1;

Mat skew(Vec v) {
  return {0.0, v.z, -v.y, -v.z, 0.0, v.x, v.y, -v.x, 0.0};
}

glm::dquat rotation(Vec r) {
  const double angle = glm::length(r);
  if (angle < 1e-12) return glm::normalize(glm::dquat(1.0, 0.5 * r));
  return glm::angleAxis(angle, r / angle);
}

Vec rotation_vector(glm::dquat q) {
  if (q.w < 0.0) q = -q;
  const Vec v(q.x, q.y, q.z);
  const double s = glm::length(v);
  if (s < 1e-12) return 2.0 * v;
  return v * (2.0 * std::atan2(s, q.w) / s);
}

/// Spatial inertia about the world's origin: [angular, mixed; mixedᵀ, linear].
struct Inertia {
  Mat angular{0.0};
  Mat mixed{0.0};
  Mat linear{0.0};
};

/// Angular and linear part: of a motion at the origin, or moment about it and force.
struct Spatial {
  Vec a{0.0};
  Vec l{0.0};
};

Spatial operator*(const Inertia& i, const Spatial& v) {
  return {i.angular * v.a + i.mixed * v.l, glm::transpose(i.mixed) * v.a + i.linear * v.l};
}

glm::dquat from_up(Vec direction, Vec axis) {
  // x along the axis of bending, z along the segment.
  return glm::normalize(glm::quat_cast(Mat(axis, glm::cross(direction, axis), direction)));
}

}  // namespace

ArticulatedChain::ArticulatedChain(Vec foot, Vec axis, double turning, double stiffness)
    : stiffness_(stiffness) {
  const glm::dquat base = from_up(glm::normalize(foot), glm::normalize(axis));
  const Vec x(1.0, 0.0, 0.0);
  relaxed_[0] = base * rotation(x * (turning / 8.0));
  for (int i = 1; i < kSegments; ++i) relaxed_[i] = rotation(x * (turning / 4.0));
  state_.frame[0] = relaxed_[0];
  for (int i = 1; i < kSegments; ++i) state_.frame[i] = state_.frame[i - 1] * relaxed_[i];
  state_.rate.fill(Vec(0.0));
}

Vec ArticulatedChain::spring_angle(const State& state, int i) const {
  const glm::dquat here = i == 0 ? state.frame[0] : glm::inverse(state.frame[i - 1]) * state.frame[i];
  const Vec local = rotation_vector(glm::inverse(relaxed_[i]) * here);
  return state.frame[i] * local;
}

std::array<Vec, 4> ArticulatedChain::accelerations(const State& state) const {
  std::array<Vec, kSegments> joint, joint_velocity, along, moment;
  std::array<Spatial, kSegments> velocity;
  Vec point(0.0), speed(0.0);
  for (int i = 0; i < kSegments; ++i) {
    along[i] = state.frame[i] * Vec(0.0, 0.0, 1.0);
    joint[i] = point;
    joint_velocity[i] = speed;
    velocity[i] = {state.rate[i], speed + glm::cross(point, state.rate[i])};
    point += 2.0 * along[i];
    speed += 2.0 * glm::cross(state.rate[i], along[i]);
    moment[i] = -(i == 0 ? 2.0 : 1.0) * stiffness_ * spring_angle(state, i);
  }
  std::array<Mat, kSegments> d_inverse;
  std::array<Inertia, kSegments> articulated;
  std::array<Spatial, kSegments> bias, drift;
  std::array<Vec, kSegments> u;
  Inertia above;
  Spatial above_bias;
  for (int i = kSegments - 1; i >= 0; --i) {
    const Vec centre = joint[i] + along[i];
    const Mat own = Mat(kAcross) + glm::outerProduct(along[i], along[i]) * (kAxial - kAcross);
    const Mat c = skew(centre);
    Inertia rod;
    rod.angular = own + c * glm::transpose(c);
    rod.mixed = c;
    rod.linear = Mat(1.0);
    const Spatial momentum = rod * velocity[i];
    const Vec centre_velocity = velocity[i].l + glm::cross(velocity[i].a, centre);
    const Vec force = Vec(0.0, 0.0, -1.0) - medium * centre_velocity;
    const Vec twist = -medium * (own * state.rate[i]);
    Inertia& ia = articulated[i];
    ia.angular = rod.angular + above.angular;
    ia.mixed = rod.mixed + above.mixed;
    ia.linear = rod.linear + above.linear;
    // V ×* (I V) minus what acts from outside.
    bias[i].a = glm::cross(velocity[i].a, momentum.a) + glm::cross(velocity[i].l, momentum.l) -
                (glm::cross(centre, force) + twist) + above_bias.a;
    bias[i].l = glm::cross(velocity[i].a, momentum.l) - force + above_bias.l;
    // Joint rates r in world axes move a body by S r = (r, p × r); p moves.
    const Vec relative = state.rate[i] - (i == 0 ? Vec(0.0) : state.rate[i - 1]);
    drift[i] = {Vec(0.0), glm::cross(joint_velocity[i], relative)};
    const Mat p = skew(joint[i]);
    const Mat ua = ia.angular + ia.mixed * p;                 // I S, its angular rows
    const Mat ul = glm::transpose(ia.mixed) + ia.linear * p;  // and linear ones
    const Mat d = ua + glm::transpose(p) * ul;                // Sᵀ I S
    d_inverse[i] = glm::inverse(d);
    u[i] = moment[i] - (bias[i].a + glm::transpose(p) * bias[i].l);
    above.angular = ia.angular - ua * d_inverse[i] * glm::transpose(ua);
    above.mixed = ia.mixed - ua * d_inverse[i] * glm::transpose(ul);
    above.linear = ia.linear - ul * d_inverse[i] * glm::transpose(ul);
    const Spatial dragged = above * drift[i];
    above_bias.a = bias[i].a + dragged.a + ua * (d_inverse[i] * u[i]);
    above_bias.l = bias[i].l + dragged.l + ul * (d_inverse[i] * u[i]);
  }
  std::array<Vec, kSegments> result;
  Spatial parent;
  for (int i = 0; i < kSegments; ++i) {
    const Mat p = skew(joint[i]);
    const Spatial carried{parent.a + drift[i].a, parent.l + drift[i].l};
    const Spatial held = articulated[i] * carried;
    const Vec r = d_inverse[i] * (u[i] - (held.a + glm::transpose(p) * held.l));
    parent = {carried.a + r, carried.l + p * r};
    result[i] = parent.a;
  }
  return result;
}

ArticulatedChain::State ArticulatedChain::moved(const State& from, const State& slope_at,
                                                const std::array<Vec, kSegments>& acceleration,
                                                double dt) const {
  State to;
  for (int i = 0; i < kSegments; ++i) {
    const glm::dquat spin = glm::dquat(0.0, slope_at.rate[i]) * slope_at.frame[i];
    to.frame[i] = glm::normalize(from.frame[i] + spin * (0.5 * dt));
    to.rate[i] = from.rate[i] + acceleration[i] * dt;
  }
  return to;
}

void ArticulatedChain::step(double dt) {
  const State& s1 = state_;
  const auto a1 = accelerations(s1);
  const State s2 = moved(state_, s1, a1, 0.5 * dt);
  const auto a2 = accelerations(s2);
  const State s3 = moved(state_, s2, a2, 0.5 * dt);
  const auto a3 = accelerations(s3);
  const State s4 = moved(state_, s3, a3, dt);
  const auto a4 = accelerations(s4);
  State next;
  for (int i = 0; i < kSegments; ++i) {
    const auto spin = [&](const State& s) { return glm::dquat(0.0, s.rate[i]) * s.frame[i]; };
    const glm::dquat sum = spin(s1) + (spin(s2) + spin(s3)) * 2.0 + spin(s4);
    next.frame[i] = glm::normalize(state_.frame[i] + sum * (dt / 12.0));
    next.rate[i] = state_.rate[i] + (a1[i] + 2.0 * (a2[i] + a3[i]) + a4[i]) * (dt / 6.0);
  }
  state_ = next;
}

void ArticulatedChain::settle() {
  // Near critical damping of the lowest mode; steps as the fastest, torsion, allows.
  medium = 0.2 * std::sqrt(stiffness_);
  const double dt = 0.15 / std::sqrt(stiffness_);
  for (int n = 0; n < 4000 || (fastest() > 1e-7 && n < 40000); ++n) step(dt);
}

void ArticulatedChain::turn(const std::array<Vec, kSegments>& rotations) {
  for (int i = 0; i < kSegments; ++i) {
    state_.frame[i] = rotation(rotations[i]) * state_.frame[i];
    state_.rate[i] = Vec(0.0);
  }
}

std::array<Vec, 4> ArticulatedChain::directions() const {
  std::array<Vec, kSegments> result;
  for (int i = 0; i < kSegments; ++i) result[i] = state_.frame[i] * Vec(0.0, 0.0, 1.0);
  return result;
}

Vec ArticulatedChain::tip() const {
  Vec tip(0.0);
  for (const Vec& t : directions()) tip += 2.0 * t;
  return tip;
}

double ArticulatedChain::energy() const {
  double energy = 0.0;
  Vec point(0.0), speed(0.0);
  for (int i = 0; i < kSegments; ++i) {
    const Vec t = state_.frame[i] * Vec(0.0, 0.0, 1.0), w = state_.rate[i];
    const Vec centre = point + t, v = speed + glm::cross(w, t);
    const double axial = glm::dot(w, t);
    const Vec psi = spring_angle(state_, i);
    energy += centre.z + 0.5 * glm::dot(v, v) + 0.5 * kAcross * (glm::dot(w, w) - axial * axial) +
              0.5 * kAxial * axial * axial + 0.5 * (i == 0 ? 2.0 : 1.0) * stiffness_ * glm::dot(psi, psi);
    point += 2.0 * t;
    speed += 2.0 * glm::cross(w, t);
  }
  return energy;
}

double ArticulatedChain::fastest() const {
  double most = 0.0;
  for (const Vec& w : state_.rate) most = std::max(most, glm::length(w));
  return most;
}

}  // namespace prairie
