// The light on something solid that stands in a sward.
#include "shaders/lib/sward_light.glsl"

vec2 open_to_light(SolidParams solid, vec3 from_eye_m) {
  return open_above(from_eye_m.z - solid.ground_from_eye_m,
                    max(0.9 * field.strip_height_m, 0.35 * solid.half_size_m.z));
}
