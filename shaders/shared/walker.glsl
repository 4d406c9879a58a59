// A walker among the grass: its bones as seen from the eye along the scene's axes, and its colours. std430.

const uint kWalkerBoneRows = 57u;  // three for each joint of agents/skeleton.h

struct WalkerParams {
  vec4 bones[kWalkerBoneRows];  // they put a point of the resting figure where it is
  vec3 skin;
  float ground_from_eye_m;  // height of the ground under its lower foot
  vec3 hair;
  float in_sward_m;  // how far up from there the sward darkens it
  vec3 jacket;
  uint seed;
  vec3 trousers;
  float reserved_trousers;  // fills the row
  vec3 shoes;
  float reserved_shoes;  // fills the row
};

const uint kWalkerSkin = 0u;
const uint kWalkerJacket = 1u;
const uint kWalkerTrousers = 2u;
const uint kWalkerShoes = 3u;
const uint kWalkerHead = 4u;  // skin and, above the hairline, hair
