#include "app/viewer/frame_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace prairie {
namespace {

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

Quality stepped(Quality quality, int steps) {
  return static_cast<Quality>(std::clamp(static_cast<int>(quality) + steps, static_cast<int>(Quality::kLow),
                                         static_cast<int>(Quality::kHigh)));
}

}  // namespace

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

void apply_frame_key(int key, FrameOptions& options) {
  switch (key) {
    case GLFW_KEY_T:
      options.tier = next_tier(options.tier);
      break;
    case GLFW_KEY_O:
      options.field_overlay = next_overlay(options.field_overlay);
      break;
    case GLFW_KEY_G:
      options.tier_tint = !options.tier_tint;
      break;
    case GLFW_KEY_M:
      options.msaa = !options.msaa;
      break;
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT:
      options.quality = stepped(options.quality.value(), -1);
      break;
    case GLFW_KEY_EQUAL:
    case GLFW_KEY_KP_ADD:
      options.quality = stepped(options.quality.value(), +1);
      break;
    default:
      break;
  }
}

}  // namespace prairie
