// What the kernels know of a species: means over its blades, and how much blades differ. std430.
// Colours are linear RGB albedos. "Spread" s means that a blade's value lies in mean · (1 ± s).

struct SpeciesParams {
  vec3 root_color;
  float dry_share;  // mean dryness of a blade, 0 = all green, 1 = all straw
  vec3 tip_color;
  float dry_spread;  // how much dryness differs from blade to blade and tuft to tuft
  vec3 dry_color;
  float hue_spread;   // how far blades stray between bluish and yellowish green, 0…1
  vec3 transmission;  // colour C of light that has crossed a blade (B11 §2.3)
  float specular;     // Ks of B11 §2.3
  float height_m;     // length of a blade along its midrib
  float height_spread;
  float width_m;  // widest place of a blade
  float width_spread;
  float tilt_rad;       // largest angle of a blade's foot to the ground's normal
  float lean_rad;       // how far a tuft combs its blades to one side
  float curvature_rad;  // turning of the midrib from foot to tip
  float curvature_spread;
  float mass_g;     // of a blade of mean size
  float stiffness;  // spring constant over m g l of a mean blade (B11 §3.1), dimensionless
  float stiffness_spread;
  float clump_m;          // distance between tufts
  float clump_strength;   // 0 = every blade for itself, 1 = blades of a tuft share height, lean and hue
  float clump_spray_rad;  // how far blades lean away from their tuft's centre
  float blade_area_m2;    // one side of a mean blade; found by the renderer
  float densest_per_m2;   // the densest stand of the field; found by the renderer
};
