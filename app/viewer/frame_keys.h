// The viewer's keys that change how frames are drawn: tier, tint, quality, smooth edges, field overlay.
#pragma once

#include "lod/quality.h"
#include "render/frame/renderer.h"

namespace prairie {

/// "low", "medium" or "high".
const char* quality_name(Quality quality);

/// What an overlay shows; "none".
const char* overlay_name(FieldOverlay overlay);

/// What pressing `key` (GLFW's code) changes: T the tier, G the tint, M smooth edges, O the field overlay, -
/// and = the quality, which must be set. Other keys change nothing.
void apply_frame_key(int key, FrameOptions& options);

}  // namespace prairie
