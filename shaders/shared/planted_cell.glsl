// A cell of one species, ready to be planted. std430.

struct PlantedCell {
  uvec2 key;            // seeds of the sequence and of the blades' attributes
  uint species;         // index into the species table
  uint planted;         // number of blades N
  vec2 offset_m;        // south-west corner relative to the tile's
  float patch_m;        // side of a density patch
  uint patches;         // m, density patches along a side
  ivec2 clump_lattice;  // tuft lattice cell at the south-west corner,
  vec2 clump_offset;    // and where in it the corner lies
  uint ground_table;    // first texel (4 words) of the cell's tables
  uint density_table;
  uint feature_table;    // kNoTable: all factors are 1
  uint feature_patches;  // feature patches along a side
  float side_m;
  float rank_offset;           // ξ in (0, 1): blade k has rank (k + ξ)/N
  float other_density_per_m2;  // mean density of the cell's other species
  uint clump_seed;             // of the world: every world has its own tufts
};
