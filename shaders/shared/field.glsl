// A field as all passes need to know it, the same for every eye: means over its blades, and where what moves
// them stands. std140 and std430.

struct FieldParams {
  vec3 mean_albedo;            // of the field's leaves, per leaf area
  float projected_from_above;  // leaf area seen straight from above per leaf area
  vec3 soil_color;
  float density_per_leaf_area;  // blades per square metre of leaf
  float strip_height_m;         // mean height of standing blades
  float blade_width_m;
  float tile_m;
  float sway_time;     // share of kSwayPeriodS that has passed
  vec2 flat_period_m;  // size of the flat tier's texture in the scene
  vec2 window_m;       // the middle of the moving fields' windows in the period of the coarsest
  vec4 planted_m;      // the west, south, east and north ends of what is planted
};
