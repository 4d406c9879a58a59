#include "app/scenes/new_scene_notes.h"

#include <fmt/format.h>

namespace prairie {
namespace {

/// What the example and scenes of one's own say alike.
SceneNotes common_notes(const char* what) {
  SceneNotes notes;
  notes.head = fmt::format(R"(# {}, made by `prairie new`.
# Metres and degrees; x east, y north, z up. Files are looked for in this folder. Colours are "#rrggbb" (sRGB)
# or [r, g, b] (linear). A mistyped key is refused, not ignored.
)",
                           what);
  notes.keys = {
      {"seed", "the same seed grows the same blades"},
      {"tile_m", "side of a tile, the unit of planting and of export"},
      {"species.density", ""},
      {"species.height_m", "length of a blade"},
      {"species.height_spread", "blades lie in mean * (1 - spread) ... mean * (1 + spread)"},
      {"species.width_mm", ""},
      {"species.tilt_deg", "largest angle of a blade's foot to the ground's normal"},
      {"species.lean_deg", "how far a tuft combs its blades to one side"},
      {"species.curvature_deg", "turning from foot to tip"},
      {"species.clump_m", "distance between tufts"},
      {"species.clump_strength", "0: every blade for itself; 1: blades of a tuft are alike"},
      {"species.dry_share", "0: all green; 1: all straw"},
      {"species.transmission", "colour of the light that crosses a blade"},
      {"camera.yaw_deg", ""},
      {"camera.pitch_deg", ""},
      {"sun.azimuth_deg", "clockwise from north"},
      {"sun.elevation_deg", ""},
      {"sun.color", ""},
      {"sun.intensity", ""},
      {"sky.intensity", ""},
      {"sky.haze_per_m", "how fast things fade with distance"},
      {"lod.quality", "low, medium or high: how early blades thin out with distance"},
      {"lod.blade_distance_m", "beyond it only the ground's colour tells of grass"},
      {"walkers.position_m", "they start strewn over a disc"},
      {"walkers.behaviour", ""},
  };
  notes.sections = {
      {"camera",
       "# Cameras for --camera NAME. z as a text \"+1.7\" is above the ground; yaw 0 looks north, "
       "clockwise;\n"
       "# pitch up is positive.\n"},
      {"wall", "# Keeps walkers on the ground.\n"},
      {"walkers",
       "# Who walks here; `prairie walk` shows them. Behaviours: wander, stroll (about where they start), "
       "visit\n"
       "# and go (to [[goal]]s).\n"},
  };
  return notes;
}

}  // namespace

SceneNotes example_notes() {
  SceneNotes notes = common_notes("A meadow in a shallow valley, with a path and a clearing");
  notes.keys.emplace("height.file", "any image that OpenImageIO reads; its first row is north");
  notes.below.emplace(
      "height",
      "# spacing_m = 2.0       # needed only where the file has no geo-reference\n"
      "# range = [0.0, 50.0]   # heights of 0 and of the largest value, for files of whole numbers\n"
      "# repeat = true         # endless ground\n");
  notes.sections.emplace(
      "species",
      "# One [[species]] for each grass, up to 16. A density is a number (blades per m², everywhere) or a "
      "map:\n"
      "# max_per_m2 * clamp((value - lo) / (hi - lo), 0, 1) ^ curve, with range = [lo, hi].\n");
  notes.sections.emplace("maps",
                         "# Factors on what the species say, from maps: blade_height, bend, color.\n");
  return notes;
}

SceneNotes raster_notes(const NewSceneRequest& request) {
  SceneNotes notes = common_notes("A scene from your own rasters");
  if (request.height_range_m)
    notes.keys.emplace("height.range", "heights of 0 and of the type's largest value");
  notes.below.emplace("height", "# repeat = true         # endless ground\n");
  if (request.density) {
    notes.above.emplace("species.density",
                        "# blades per m² = max_per_m2 * clamp((value - lo) / (hi - lo), 0, 1) ^ curve, with\n"
                        "# range = [lo, hi]\n");
  } else {
    notes.keys["species.density"] = "blades per m², everywhere";
  }
  return notes;
}

}  // namespace prairie
