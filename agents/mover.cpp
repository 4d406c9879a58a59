#include "agents/mover.h"

namespace prairie {

Mover::Mover(MoverPath path) : path_(std::move(path)), points_m_(path_.path_m), distances_m_(path_.path_m.size()) {}
double Mover::length_m() const { return distances_m_.back(); }
MoverPlace Mover::place(const HeightField&, double) const { return {}; }
std::vector<Solid> solids_of(const MoverPath&, const MoverPlace&) { return {}; }
std::vector<TreadStep> tread_steps(const MoverPath&, const MoverPlace&, const MoverPlace&, std::uint32_t) { return {}; }

}  // namespace prairie
