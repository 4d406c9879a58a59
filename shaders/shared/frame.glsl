// What all passes of a frame know: camera, light, thinning. std140 and std430.

struct FrameParams {
  mat4 clip_from_eye;  // the eye's frame: origin at the eye, the scene's axes
  vec3 towards_eye;    // in a parallel projection
  float parallel;      // 1 in a parallel projection, else 0
  vec3 sun_direction;  // towards the sun
  float pixel_m;       // height of a pixel at 1 m (anywhere, in a parallel projection)
  vec3 sun_radiance;   // Id* of B11 §2.3
  float haze_per_m;    // b of RG "Fog"
  vec3 top_ambient;    // Ia*
  float exposure;
  vec3 root_ambient;           // Ia**
  float shade_density_per_m2;  // density at which self-shading has 56 % of its strength (shade_of)
  vec3 zenith_radiance;
  float sun_halo;  // exponent of the haze's glow around the sun
  vec3 horizon_radiance;
  float flat_period_x_m;   // size of the flat tier's texture in the scene
  vec3 ground_from_eye_m;  // the ground mesh's anchor as seen from the eye
  float flat_period_y_m;
  vec3 soil_color;
  float tint;                   // 1: tiers are tinted
  vec3 mean_albedo;             // of the field's leaves, per leaf area
  float projected_from_above;   // leaf area seen straight from above per leaf area
  vec3 lod_eye_m;               // the eye for which tiers are chosen, as seen from the camera's
  float density_per_leaf_area;  // blades per square metre of leaf, mean of the field
  vec2 anchor_m;                // the anchor's place in the scene
  vec2 jitter;                  // sub-pixel shift of clip space
  float strip_height_m;         // mean height of standing blades
  float tile_m;
  float blade_width_m;           // mean of the field
  float sway_time;               // share of kSwayPeriodS that has passed
  vec2 eye_in_tile_m;            // from the south-west corner of the tile that it is above
  vec2 field_centre_from_eye_m;  // the middle of the moving fields' windows,
  vec2 field_centre_m;           // and its place in the period of the coarsest
  vec2 reserved;                 // fills the row
  LodCoefficients lod;
};
