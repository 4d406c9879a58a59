#version 450 core
// Plants and poses the blades of a batch and gives each its vertices, lit (B11 §2.3), as seen from the eye
// (docs/design.md, D3). Vertices come in pairs from the foot up. Lit here, since blades are a pixel or two
// wide.
//
// Made twice: with SPLINE_BLADES for the cells next to the eye (B11 §2.1), else for Hermite blades (G03
// §3.3); both have the same pose, and the first turns into the second over a band of distances. And each with
// MOVING, where wind blows, and with TRODDEN besides, where something has trodden; where conditions may have
// come over the grass with CONDITIONED; for cells with blades that move by themselves also with TOUCHED.
#ifdef MOVING
#define SWAYING_BLADES
#endif
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"
#include "shaders/lib/planting.glsl"
#include "shaders/lib/haze.glsl"
#include "shaders/lib/sward_look.glsl"
#include "shaders/lib/tint.glsl"
#if defined(MOVING) || defined(CONDITIONED)
#include "shaders/lib/moving_fields.glsl"
#endif
#ifdef TOUCHED
#include "shaders/lib/touched_blades.glsl"
#endif

layout(std430, binding = kResultBuffer) writeonly buffer GrownVertices {
  uvec4 vertices[];
};  // GrownVertex
layout(location = kGrowSegments) uniform uint segments;
layout(location = kGrowFirstVertex) uniform uint first_vertex;

#ifdef SPLINE_BLADES
vec3 tier_tinted(vec3 radiance) {
  return tinted_tier(radiance, kSplineTint);
}
#define Midrib BladeChain
vec3 midrib_point(BladeChain chain, float t) {
  return chain_point(chain, t);
}
#else
vec3 tier_tinted(vec3 radiance) {
  return tinted_tier(radiance, kHermiteTint);
}
#define Midrib BladeCurve
vec3 midrib_point(BladeCurve curve, float t) {
  return hermite_point(curve.base_m, curve.tip_m, curve.base_tangent_m, curve.tip_tangent_m, t);
}
#endif

// Across the blade at one place, left and right.
struct Rib {
  vec3 left_m, right_m;
  vec3 left, right;  // radiance
};

Rib between(Rib a, Rib b) {
  return Rib(0.5f * (a.left_m + b.left_m), 0.5f * (a.right_m + b.right_m), 0.5f * (a.left + b.left),
             0.5f * (a.right + b.right));
}

Rib mixed(Rib a, Rib b, float t) {
  return Rib(mixed(a.left_m, b.left_m, t), mixed(a.right_m, b.right_m, t), mixed(a.left, b.left, t),
             mixed(a.right, b.right, t));
}

void store(uint vertex, Rib rib, Haze haze) {
  vertices[vertex] = uvec4(floatBitsToUint(rib.left_m), pack_radiance(hazed(rib.left, haze)));
  vertices[vertex + 1u] = uvec4(floatBitsToUint(rib.right_m), pack_radiance(hazed(rib.right, haze)));
}

// Both sides of a tip are one vertex.
void store_tip(uint vertex, Rib rib, Haze haze) {
  vertices[vertex] =
      uvec4(floatBitsToUint(rib.left_m), pack_radiance(hazed(0.5f * (rib.left + rib.right), haze)));
}

struct GrownBlade {
  Midrib midrib;
  vec3 eye_from_tile_m, to_eye;
  float width_m;
  vec3 root_color, tip_color, transmission;
  float specular, shade, ground_n_dot_v;
  vec3 mean_radiance;
  float own_share;
};

// `profile`, `place`, `l6`: width there as a share of the widest place, where its colour is from, and l⁶
// (shaders/kernels/blade_mesh.glsl). `reach`: to the ribs on either side; a rib lies across the mesh, not the
// curve, or a coarse mesh of a bent blade would be too narrow.
Rib rib_at(GrownBlade blade, float t, float reach, float profile, float place, float l6) {
  vec3 centre_m = blade.eye_from_tile_m + midrib_point(blade.midrib, t);
  vec3 along_m =
      midrib_point(blade.midrib, min(t + reach, 1.0f)) - midrib_point(blade.midrib, max(t - reach, 0.0f));
  BladeSurface surface = blade_surface(along_m, blade.midrib.side, blade.to_eye);
  vec3 half_width_m = surface.side * (0.5f * blade.width_m * profile);
  vec3 albedo = mixed(blade.root_color, blade.tip_color, place);
  vec3 left = blade_radiance_around(light, albedo, blade.transmission, blade.specular, place, l6, blade.shade,
                                    inner(surface.left, light.sun_direction), blade.ground_n_dot_v);
  vec3 right =
      blade_radiance_around(light, albedo, blade.transmission, blade.specular, place, l6, blade.shade,
                            inner(surface.right, light.sun_direction), blade.ground_n_dot_v);
  return Rib(centre_m - half_width_m, centre_m + half_width_m,
             tier_tinted(mixed(blade.mean_radiance, left, blade.own_share)),
             tier_tinted(mixed(blade.mean_radiance, right, blade.own_share)));
}

// How many of its cell's blades stand where this one does, and how far it has grown in.
struct Thinning {
  float distance_m, pixel_m;  // from the eye that tiers are chosen for; height of a pixel there
  float kept, crowded;        // shares that stay, by size on the screen and by density
  float growth;
};

Thinning thinning_at(DrawnCell drawn, SpeciesParams species, uint k, vec3 root_m, vec3 normal) {
  Thinning thinning;
  vec3 from_lod_eye_m = root_m - view.lod_eye_m;
  thinning.distance_m = sqrt(inner(from_lod_eye_m, from_lod_eye_m));
  vec3 to_lod_eye =
      view.parallel > 0.5f ? view.towards_eye : -from_lod_eye_m / max(thinning.distance_m, 1.0e-6f);
  thinning.pixel_m = view.parallel > 0.5f ? view.pixel_m : view.pixel_m * thinning.distance_m;
  thinning.kept =
      keep_share(view.lod, inner(normal, to_lod_eye), thinning.pixel_m, thinning.distance_m, species.width_m);
  thinning.crowded = crowded_share(view.lod, mean_density_per_m2(drawn.planted));
  float rank = (float(int(k)) + drawn.planted.rank_offset) / float(int(drawn.planted.planted));
  thinning.growth = growth_of(view.lod, thinning.kept * thinning.crowded * blades_left(drawn.morph), rank);
  return thinning;
}

// The blade with its foot slid towards the nearest edge of its tile, as far as the tile has morphed.
Blade slid(Blade blade, GroundPoint ground, float morph) {
  if (morph > 0.0f) {
    vec2 slid_m = slid_root(blade.root_m, field.tile_m, morph);
    blade.ground_m += inner(vec3(ground.slope, 0.0f), vec3(slid_m - blade.root_m, 0.0f));
    blade.root_m = slid_m;
  }
  return blade;
}

// A blade as wind, treads and what came over the grass leave it.
struct Stance {
  Blade blade;
  BladeChain chain;
  vec2 lean;          // of the sward around, as a share of its length
  vec3 color_factor;  // of its features and of conditions
};

Stance stance_of(Blade blade, GroundPoint ground, vec3 normal, DrawnCell drawn, vec3 color_factor,
                 float growth) {
  Stance stance;
  stance.lean = vec2(0.0f);
  stance.color_factor = color_factor;
#if defined(MOVING) || defined(CONDITIONED)
  vec2 field_from_eye_m = drawn.eye_from_tile_m.xy + blade.root_m;
#endif
#ifdef CONDITIONED
  vec4 condition = condition_at(field_from_eye_m);
  stance.color_factor *= condition.rgb;
#endif
#ifdef MOVING
  Swaying swaying = swaying_at(field_from_eye_m, drawn.planted.species);
  vec3 swayed = swayed_tip(swaying);
  stance.lean = swayed.xy;
  ChainVectors load = texel_load(swaying.texel1, swaying.texel2, swaying.texel3, swaying.texel4);
#ifdef TRODDEN
  Pressing pressing = pressing_at(field_from_eye_m);
  stance.lean += lean_of(pressing);
  blade.height_m *= worn_length(pressing.wear);
  blade.dryness = lerp(blade.dryness, 1.0f, 0.5f * pressing.wear);
#endif
  BladeCurve rest = pose_blade(blade, ground.slope, growth);
  // Before stiffness changes: another frequency of its own would throw a blade out of its phase.
  load = with_own_sway(blade, rest, load, swayed, field.sway_time);
#else
  BladeCurve rest = pose_blade(blade, ground.slope, growth);
#endif
#ifdef CONDITIONED
  blade.stiffness *= condition.a;
#endif
#if defined(TRODDEN)
  stance.chain = pressed_virtual_pose(blade, rest, growth, load, normal, pressing);
#elif defined(MOVING)
  stance.chain = virtual_pose(blade, rest, growth, load);
#else
  stance.chain = chain_of(blade, rest, growth);
#endif
  stance.blade = blade;
  return stance;
}

// The mean colour of the sward there, which blades fade to.
vec3 mean_radiance_at(vec3 root_m, vec3 normal, float height_m, uint species, float density_per_m2,
                      float blade_height, float shade) {
  vec3 seen_m = root_m + vec3(0.0f, 0.0f, 0.6f * height_m);
  vec3 to_eye = view.parallel > 0.5f ? view.towards_eye : normalized(-seen_m);
  SwardSight sight = sward_sight(normal, to_eye);
  float optical_depth =
      sward_optical_depth(sight, density_per_m2 / field.density_per_leaf_area * blade_height);
  return sward_color(1 + int(species), sight, optical_depth, shade);
}

// Its width, so that the cover of all that it stands for stays.
float width_of(Midrib midrib, vec3 to_eye, Thinning thinning, float own_m, float mean_m, float own_share,
               float coarser) {
  SeenAreas seen =
      seen_areas(midrib_point(midrib, 0.0f), midrib_point(midrib, 0.25f), midrib_point(midrib, 0.5f),
                 midrib_point(midrib, 0.75f), midrib_point(midrib, 1.0f), to_eye);
  float wider = wider_for_chords(seen, int(segments), coarser);
  return thinning.growth > 0.0f ? widened_m(view.lod, thinning.kept * thinning.crowded,
                                            wider * lerp(mean_m, own_m, own_share), thinning.pixel_m)
                                : 0.0f;
}

// Every other rib is also one of the coarser mesh; those between them move to the middle of their neighbours.
void store_ribs(uint first, GrownBlade grown, float coarser, Haze haze) {
  float h = 1.0f / float(int(segments));
  uint step = min(segments, 2u);
  Rib last = Rib(vec3(0.0f), vec3(0.0f), vec3(0.0f), vec3(0.0f));
  for (uint n = 0u; n <= segments; n += step) {
    float t = float(int(n)) * h;
    Rib rib = rib_at(grown, t, h * (1.0f + coarser), blended_profile(t, h, coarser),
                     blended_place(t, h, coarser), blended_power6(t, h, coarser));
    if (n < segments) {
      store(first + 2u * n, rib, haze);
    } else {
      store_tip(first + 2u * n, rib, haze);
    }
    if (n > 0u && step == 2u) {
      float t_between = t - h;
      Rib own = rib_at(grown, t_between, h, mean_profile(t_between, h), mean_place(t_between, h),
                       mean_power6(t_between, h));
      store(first + 2u * n - 2u, mixed(own, between(last, rib), coarser), haze);
    }
    last = rib;
  }
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= blade_count) return;
  uint cell_index = cell_of(index);
  DrawnCell drawn = load_cell(cell_index);
  PlantedCell cell = drawn.planted;
  uint k = quarter_index(drawn.quarter, index - drawn.first_blade + drawn.first_index);

  SpeciesParams species = load_species(cell.species);
  WarpedRoot root = plant_root(cell, k);
  vec2 local_m = root_in_cell(cell, root);
  GroundPoint ground = ground_in_cell(cell.ground_table, cell.side_m, local_m);
  Features features = planting_features(cell, local_m);

  vec3 root_m = drawn.eye_from_tile_m + vec3(cell.offset_m + local_m, ground.height_m);
  vec3 normal = normalized(vec3(-ground.slope, 1.0f));
  Thinning thinning = thinning_at(drawn, species, k, root_m, normal);
  Blade planted = grow_blade(cell, species, k, local_m, traits_of(cell.key.y, k),
                             clump_of(cell, species, local_m), features, ground.height_m);
  Stance stance =
      stance_of(slid(planted, ground, drawn.morph), ground, normal, drawn, features.color, thinning.growth);
#ifdef TOUCHED
  uint slot = touched_slot(cell_index, k);
  if (slot != 0u) stance.chain = touched_chain(slot, thinning.growth);
#endif
#ifdef SPLINE_BLADES
  Midrib midrib = blended_chain(stance.chain, hermite_share(view.lod, thinning.distance_m));
#else
  Midrib midrib = curve_of(stance.chain);
#endif
  // A blade that stands for many looks like their mean the more, the more they are: what n blades differ by,
  // their mean does by its √n-th part. Of those that are left out where it is crowded about a half would have
  // been hidden.
  float own_share = sqrt(area_left(view.lod, thinning.kept * sqrt(thinning.crowded)));

  vec3 to_eye = view.parallel > 0.5f ? view.towards_eye : normalized(-root_m);
  float coarser = coarser_share(view.lod, int(segments), species.height_m / thinning.pixel_m);
  float density_per_m2 = root.density + cell.other_density_per_m2;
  float shade = shade_of(density_per_m2, light.shade_density_per_m2);
  vec3 mean_radiance = mean_radiance_at(root_m, normal, stance.blade.height_m, cell.species, density_per_m2,
                                        features.blade_height, shade) *
                       stance.color_factor;
#ifdef MOVING
  mean_radiance *= leaning_light(normal, stance.lean);
#endif
  float width_m =
      width_of(midrib, to_eye, thinning, stance.blade.width_m, species.width_m, own_share, coarser);
  GrownBlade grown = GrownBlade(
      midrib, drawn.eye_from_tile_m, to_eye, width_m,
      root_albedo(species, stance.blade.hue, stance.blade.dryness) * stance.color_factor,
      tip_albedo(species, stance.blade.hue, stance.blade.dryness) * stance.color_factor, species.transmission,
      species.specular, shade, inner(normal, to_eye), mean_radiance, own_share);
  store_ribs(first_vertex + index * (2u * segments + 1u), grown, coarser, haze_at(root_m));
}
