// Smooth noise in [0, 1] with one random value per unit square; for surfaces without a map of their own. Read
// from a texture: hashing four corners costs a software renderer several times as much.
layout(binding = kNoiseUnit) uniform sampler2D noise_texture;

// The same, averaged over the pixel's footprint, so that it fades into its mean with distance instead of
// shimmering.
float filtered_noise(vec2 p) {
  return texture(noise_texture, (p + 0.5) / float(kNoiseSide)).r;
}

float value_noise(vec2 p) {
  return textureLod(noise_texture, (p + 0.5) / float(kNoiseSide), 0.0).r;
}
