// The light of a scene: sun, sky and haze. std140 and std430.

struct LightParams {
  vec3 sun_direction;  // towards the sun
  float haze_per_m;    // b of RG "Fog"
  vec3 sun_radiance;   // Id* of B11 §2.3
  float sun_halo;      // exponent of the haze's glow around the sun
  vec3 top_ambient;    // Ia*
  float exposure;
  vec3 root_ambient;           // Ia**
  float shade_density_per_m2;  // density at which self-shading has 56 % of its strength (shade_of)
  vec3 zenith_radiance;
  float reserved_1;  // fills the row
  vec3 horizon_radiance;
  float reserved_2;  // fills the row
};
