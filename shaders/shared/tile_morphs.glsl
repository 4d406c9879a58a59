// The texture of how far tiles around the eye have morphed (FramePlan::morphs): one texel a tile, the eye's
// in the middle.
const int kTileMorphSide = 256;
const float kTileMorphSteps = 254.0f;  // what stands for 1; 255 stands for a tile that is not in view
