// What a person chooses of how frames are drawn, as it is called and in the order in which a key goes through
// it.
#pragma once

#include "lod/frame_plan.h"
#include "lod/quality.h"
#include "render/overlays/field_overlay.h"

namespace prairie {

/// "low", "medium" or "high".
const char* quality_name(Quality quality);
/// So many steps higher, at most high and at least low.
Quality stepped(Quality quality, int steps);

/// What an overlay shows; "none".
const char* overlay_name(FieldOverlay overlay);
FieldOverlay next_overlay(FieldOverlay overlay);

/// From auto through the tiers, the nearest first.
Tier next_tier(Tier tier);

}  // namespace prairie
