#version 450 core
// Colours of the field overlays: the wind from blue over yellow to red; heat from yellow over red to violet;
// recovery from green, nearly risen, to red, and worn ground blue. Unlit: a colour means the same in any
// light.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"

layout(location = kOverlayShown) uniform float shown;

layout(location = 0) in vec3 from_eye_m;
layout(location = 1) in float heat;
layout(location = 2) in float wear;
layout(location = 3) in float outline;
layout(location = 0) out vec4 color;

vec3 ramp(vec3 low, vec3 middle, vec3 high, float share) {
  return share < 0.5 ? mix(low, middle, 2.0 * share) : mix(middle, high, 2.0 * share - 1.0);
}

// Over the last quarter of its reach an overlay fades out.
float near(float reach_m) {
  return 1.0 - smoothstep(0.75 * reach_m, reach_m, length(from_eye_m.xy));
}

void main() {
#if defined(WIND_ARROWS)
  vec3 radiance = ramp(vec3(0.02, 0.12, 0.8), vec3(0.75, 0.45, 0.01), vec3(0.7, 0.02, 0.01), heat);
  color = vec4(mix(radiance, vec3(0.0), outline), mix(0.95, 0.6, outline) * near(24.0));
#elif defined(TILT_HEAT)
  vec3 radiance = ramp(vec3(0.75, 0.5, 0.01), vec3(0.75, 0.07, 0.01), vec3(0.3, 0.0, 0.35), heat);
  color = vec4(radiance, 0.75 * smoothstep(0.02, 0.3, heat) * near(30.0));
#else
  vec3 radiance = ramp(vec3(0.02, 0.6, 0.1), vec3(0.75, 0.45, 0.01), vec3(0.75, 0.03, 0.01), heat);
  float worn = smoothstep(0.0, 0.6, wear);
  radiance = mix(radiance, vec3(0.02, 0.08, 0.7), worn);
  color = vec4(radiance, max(0.7 * smoothstep(0.0, 0.1, heat), 0.7 * worn) * near(30.0));
#endif
  color.rgb /= light.exposure;
  color.a *= shown;
}
