// Sizes that both sides count with: structs in texels of four words, and the planting shaders' workgroup.

const int kBladeTexels = 4;
const int kCellTexels = 7;
const int kSpeciesTexels = 8;
const int kStripTileTexels = 8;
const int kStripVertexTexels = 2;
const int kStripQuads = 4;  // along a side of a tile, where strips are near
const int kPlantingGroup = 64;

// No blade is longer than the mean by more than this many spreads (grow_blade in shaders/kernels/plant.glsl:
// 0.5 + 0.8).
const float kTallestSpread = 1.3f;

const int kNoiseSide = 128;  // texels of the noise texture (shaders/lib/value_noise.glsl)
