// A solid thing among the grass, as seen from the eye along the scene's axes. std430.

struct SolidParams {
  vec3 centre_from_eye_m;
  float ground_from_eye_m;  // height of the ground under it
  vec3 forward;             // the thing's own axes: unit vectors
  float outline_roughness;  // greatest depth of dents, as a share of the radius
  vec3 left;
  float edge_m;  // radius of a box's rounded edges
  vec3 up;
  uint seed;
  vec3 half_size_m;  // along forward, left and up
  uint shape;        // kSolidSphere, …
  vec3 albedo;
  float reserved_solid;  // fills the row
};

const uint kSolidSphere = 0u;
const uint kSolidBox = 1u;
const uint kSolidWheel = 2u;

// A wheel's parts, as shares of its radius.
const float kRimInside = 0.84f;
const float kTyreInside = 0.945f;
const float kHubRadius = 0.19f;
