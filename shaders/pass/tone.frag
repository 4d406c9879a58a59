#version 450 core
// From linear light to an 8-bit picture: exposure, tone curve, sRGB.
#include "shaders/shared/bindings.glsl"
#include "shaders/kernels/interpolation.glsl"
#include "shaders/kernels/tone.glsl"

layout(binding = kLinearPictureUnit) uniform sampler2D linear_picture;
layout(location = kToneExposure) uniform float exposure;
layout(location = 0) out vec4 color;

void main() {
  vec3 linear = exposure * texelFetch(linear_picture, ivec2(gl_FragCoord.xy), 0).rgb;
  color = vec4(srgb_from_linear(tone_curve(linear.r)), srgb_from_linear(tone_curve(linear.g)),
               srgb_from_linear(tone_curve(linear.b)), 1.0);
}
