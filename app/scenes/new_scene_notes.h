// The comments in the scene.toml that `prairie new` writes: a text to edit, not only to read back.
#pragma once

#include "app/scenes/new_scene.h"
#include "world/scene/scene_text.h"

namespace prairie {

SceneNotes example_notes();
SceneNotes raster_notes(const NewSceneRequest& request);

}  // namespace prairie
