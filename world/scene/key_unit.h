// Units that people think in, and those of the members that their numbers go to.
#pragma once

namespace prairie {

/// A key's unit, where it is not its member's own.
enum class Unit {
  kMembers,
  kMillimetres,  // metres in the member
  kDegrees,      // radians
  kBearing,      // degrees clockwise from north; radians from east, counter-clockwise
};

double member_from_key(Unit unit, double value);

/// The shortest decimal that member_from_key() makes exactly this value of: once it is a float, if
/// `is_float`.
double key_from_member(Unit unit, double value, bool is_float);

}  // namespace prairie
