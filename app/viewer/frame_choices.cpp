#include "app/viewer/frame_choices.h"

#include <algorithm>

namespace prairie {
const char* quality_name(Quality quality) {
  switch (quality) {
    case Quality::kLow:
      return "low";
    case Quality::kMedium:
      return "medium";
    case Quality::kHigh:
      break;
  }
  return "high";
}

Quality stepped(Quality quality, int steps) {
  return static_cast<Quality>(std::clamp(static_cast<int>(quality) + steps, static_cast<int>(Quality::kLow),
                                         static_cast<int>(Quality::kHigh)));
}

const char* overlay_name(FieldOverlay overlay) {
  switch (overlay) {
    case FieldOverlay::kNone:
      break;
    case FieldOverlay::kWind:
      return "wind";
    case FieldOverlay::kTilt:
      return "trodden grass";
    case FieldOverlay::kRecovery:
      return "recovery and wear";
  }
  return "none";
}

FieldOverlay next_overlay(FieldOverlay overlay) {
  switch (overlay) {
    case FieldOverlay::kNone:
      return FieldOverlay::kWind;
    case FieldOverlay::kWind:
      return FieldOverlay::kTilt;
    case FieldOverlay::kTilt:
      return FieldOverlay::kRecovery;
    case FieldOverlay::kRecovery:
      break;
  }
  return FieldOverlay::kNone;
}

Tier next_tier(Tier tier) {
  switch (tier) {
    case Tier::kAuto:
      return Tier::kSpline;
    case Tier::kSpline:
      return Tier::kHermite;
    case Tier::kHermite:
      return Tier::kStrip;
    case Tier::kStrip:
      return Tier::kFlat;
    case Tier::kFlat:
      break;
  }
  return Tier::kAuto;
}

}  // namespace prairie
