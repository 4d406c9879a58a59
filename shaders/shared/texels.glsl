// Sizes that both sides count with: structs in texels of four words, and the planting shaders' workgroup.

const int kBladeTexels = 4;
const int kCellTexels = 7;
const int kSpeciesTexels = 8;
const int kPosedTexels = 5;
const int kPlantingGroup = 64;
