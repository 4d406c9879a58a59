// Things that move over the grass along a path and press it down: a rolling stone (G03 fig. 4) and a cart.
// Where they are is a function of time alone, so that nothing of them has to be kept. No OpenGL, no files.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "agents/smooth_path.h"
#include "animation/solids.h"
#include "animation/treading.h"
#include "maps/height_field.h"

namespace prairie {

enum class MoverKind { kStone, kCart };

struct MoverPath {
  MoverKind kind = MoverKind::kStone;
  double radius_m = 0.4;       // of the stone; half the width of the cart; 0.05…3
  double speed_m_per_s = 1.0;  // along the path as seen from above, 0…20
  double start_s = 0.0;        // before it, it stands at the first point
  bool loops = false;          // from the last point back to the first, for ever; else it stops at the last
  std::vector<glm::dvec2> path_m;  // at least two points; passed on a smooth curve through all of them
};

/// Throws BadInput, the field in it, on a path of fewer than two different points or of more than 10 000, or
/// on a number that is not finite or out of range.
void check(const MoverPath& mover);

/// Where a mover is: on the ground, which it leans with.
struct MoverPlace {
  glm::dvec3 centre_m{0.0};  // of the stone; of the cart's box
  glm::dmat3 axes{1.0};  // unit columns: forward, left, up of the thing itself; a stone's turn as it rolls
  glm::dvec2 contact_m{0.0};  // where it touches the ground; between the wheels
  glm::dvec2 forward{1.0, 0.0};
};

/// One mover, its path measured.
class Mover {
 public:
  /// Throws BadInput as check() does.
  explicit Mover(MoverPath path);

  const MoverPath& path() const { return path_; }
  double length_m() const { return way_.length_m(); }
  MoverPlace place(const HeightField& ground, double time_s) const;

 private:
  MoverPath path_;
  SmoothPath way_;
};

/// A stone that has rolled so far without slipping; a cart on its wheels. `forward` is a unit vector.
MoverPlace stone_place(const HeightField& ground, double radius_m, glm::dvec2 contact_m, glm::dvec2 forward,
                       double rolled_m);
MoverPlace cart_place(const HeightField& ground, double half_width_m, glm::dvec2 contact_m,
                      glm::dvec2 forward);

/// From the hind axle to the front one.
double cart_wheelbase_m(double half_width_m);

/// What blades are bent out of: the stone's sphere; the cart's box and wheels (capsules).
std::vector<Solid> solids_of(MoverKind kind, double radius_m, const MoverPlace& place);

/// Its steps from one place to the next, ids from `first_id` on: one for a stone, one for each wheel of a
/// cart. Both always touch the ground; what stands makes steps without a way.
std::vector<TreadStep> tread_steps(MoverKind kind, double radius_m, const MoverPlace& from,
                                   const MoverPlace& to, std::uint32_t first_id);
inline constexpr std::uint32_t kTreadIdsPerMover = 4;

}  // namespace prairie
