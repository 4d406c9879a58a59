// Wood and iron of a cart: boards with their own tones, spoked wheels with tyres.
#include "shaders/lib/noise_3d.glsl"

// Wood that grows along x of `place_m`, of one piece by its number.
vec3 wood_albedo(vec3 albedo, vec3 place_m, uint piece, float pixel_m) {
  vec3 tone = lattice_values(ivec3(int(piece), 3, 7), 11u);
  vec3 fibre = noise_3d(place_m * vec3(1.3, 160.0, 160.0) + 17.0 * tone, piece);
  vec3 streak = noise_3d(place_m * vec3(0.6, 30.0, 30.0) + 31.0 * tone, piece + 1u);
  float grain = mix(0.5, fibre.x, seen_share(0.006, pixel_m));
  float weathered = 0.65 + 0.35 * tone.y;
  vec3 grey = vec3(dot(albedo, vec3(0.35, 0.45, 0.20)));
  return mix(grey, albedo, weathered) * (0.72 + 0.42 * tone.x) * (0.80 + 0.40 * grain) *
         (0.80 + 0.40 * streak.x);
}

// A face of a box, made of boards as wide as a board is: dark where two meet.
vec3 board_albedo(SolidParams solid, vec3 in_body_m, vec3 normal, float pixel_m) {
  // Boards run along the longer side of the face.
  vec3 towards = abs(normal);
  int face = towards.x >= towards.y && towards.x >= towards.z ? 0 : towards.y >= towards.z ? 1 : 2;
  ivec2 sides = face == 0 ? ivec2(1, 2) : face == 1 ? ivec2(0, 2) : ivec2(0, 1);
  if (solid.half_size_m[sides.y] > solid.half_size_m[sides.x]) sides = sides.yx;
  float along = in_body_m[sides.x];
  float across = in_body_m[sides.y];
  float half_across_m = solid.half_size_m[sides.y];
  const float kBoardM = 0.13;
  float boards = max(round(2.0 * half_across_m / kBoardM), 1.0);
  float place = clamp((across / half_across_m * 0.5 + 0.5) * boards, 0.0, boards - 1.0e-3);
  uint piece = solid.seed * 37u + uint(place);
  float board_m = 2.0 * half_across_m / boards;
  float to_joint_m = min(fract(place), 1.0 - fract(place)) * board_m;
  bool at_joint = boards > 1.5 && place > 0.5 && place < boards - 0.5;
  float joint = at_joint ? 1.0 - smoothstep(0.003, 0.003 + max(0.006, pixel_m), to_joint_m) : 0.0;
  vec3 albedo = wood_albedo(solid.albedo, vec3(along, across, 0.01 * float(face)), piece, pixel_m);
  return albedo * (1.0 - 0.72 * joint * min(1.0, 0.008 / max(pixel_m, 1.0e-5) + 0.25));
}

const float kSpokes = 12.0;
const float kSpokeHalfWidth = 0.042;  // of the radius

// The colour of a wheel; negative where one looks through between its spokes.
vec3 wheel_albedo(SolidParams solid, vec3 in_body_m, vec3 normal, float pixel_m) {
  vec2 place = in_body_m.xz / solid.half_size_m.x;
  float from_hub = length(place);
  float turn = atan(place.y, place.x) * (kSpokes / 6.2831853);
  float spoke = floor(turn + 0.5);
  uint piece = solid.seed * 53u + uint(int(spoke) + 64);
  float to_spoke = abs(turn - spoke) * (6.2831853 / kSpokes) * from_hub;
  if (from_hub > kTyreInside) {
    float rust = 0.6 * noise_3d(in_body_m * 45.0, solid.seed + 20u).x +
                 0.4 * noise_3d(in_body_m * 130.0, solid.seed + 21u).x;
    return mix(vec3(0.052, 0.046, 0.042), vec3(0.085, 0.055, 0.038), smoothstep(0.35, 0.70, rust));
  }
  vec2 outward = place / max(from_hub, 1.0e-4);
  float along = dot(in_body_m.xz, outward);
  float side = dot(in_body_m.xz, vec2(-outward.y, outward.x));
  // The mesh is a polygon, whose sides lie a little within the circle.
  if (from_hub > 0.995 * kRimInside) {
    // Felloes, each as long as two spokes are apart, dark where two meet.
    float joint_m = abs(fract(0.5 * turn) - 0.5) * 2.0 * (6.2831853 / kSpokes) * solid.half_size_m.x;
    uint felloe = solid.seed * 71u + uint(int(floor(0.5 * turn)) + 64);
    vec3 albedo = wood_albedo(solid.albedo, vec3(turn * 0.12, along, in_body_m.y), felloe, pixel_m);
    return albedo * mix(0.45, 1.0, smoothstep(0.0, 0.010 + pixel_m, joint_m));
  }
  if (from_hub < kHubRadius + 1.0e-3) {
    // An iron cap with its bolts round the axle's end.
    if (abs(normal.y) > 0.5 && from_hub < 0.10) return vec3(0.045);
    return 0.75 * wood_albedo(solid.albedo, vec3(in_body_m.y, place), solid.seed, pixel_m);
  }
  if (to_spoke > kSpokeHalfWidth) return vec3(-1.0);
  vec3 albedo = wood_albedo(solid.albedo, vec3(along, side, in_body_m.y), piece, pixel_m);
  return albedo * mix(1.0, 0.6, smoothstep(0.5, 1.0, to_spoke / kSpokeHalfWidth));
}
