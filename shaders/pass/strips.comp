#version 450 core
// The strips around tiles (G03 §3.4), as seen from the eye: one invocation makes the foot and the top of one
// column of a strip. Strips of both tiles of an edge coincide, each grown by its own tile's morph.
//
// Deviation: a strip has no light of its own. It is painted in the mean colour that the tile's blades would
// show from here (lod/sward/sward_response.h); its texture holds what single blades differ from that by.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"
layout(local_size_x = kPlantingGroup) in;

vec4 table_texel(uint texel) {
  return vec4(0.0f);
}
#include "shaders/lib/kernels.glsl"
#include "shaders/lib/species.glsl"
#include "shaders/lib/haze.glsl"
#include "shaders/lib/sward_look.glsl"
#include "shaders/lib/tint.glsl"
#include "shaders/lib/litter.glsl"
#if defined(MOVING) || defined(CONDITIONED)
#include "shaders/lib/moving_fields.glsl"
#endif

layout(binding = kStripTileUnit) uniform usamplerBuffer tile_texels;  // StripTile
layout(binding = kStripTraitsUnit) uniform samplerBuffer
    strip_traits;  // StripTraits (render/grass/strip_pass.h), by species
layout(std430, binding = kResultBuffer) writeonly buffer StripVertices {
  uvec4 vertices[];
};  // StripVertex
layout(location = kLayColumnCount) uniform uint column_count;
layout(location = kLayFirstTile) uniform uint first_tile;
layout(location = kLayFirstColumn) uniform uint first_column;
layout(location = kLayQuads) uniform uint quads;  // along a side

const int kSides = 4;

// What the tile's blades would show along the line of sight to a place: themselves, and where one sees
// between the rows of strips as much of the floor as there, or the rows would stand out as lines.
uint radiance_at(vec3 from_eye_m, vec3 normal, vec2 lean, float density_per_m2, float height_m,
                 float blade_height, vec3 color_factor, uint species) {
  vec3 to_eye = normalized(-from_eye_m);
  SwardSight sight = sward_sight(normal, to_eye);
  float optical_depth =
      sward_optical_depth(sight, density_per_m2 / field.density_per_leaf_area * blade_height);
  vec3 color = sward_color(1 + int(species), sight, optical_depth,
                           shade_of(density_per_m2, light.shade_density_per_m2));
#ifdef MOVING
  color *= leaning_light(normal, lean);
#endif
  float crossing =
      min(height_m * (abs(to_eye.x) + abs(to_eye.y)) / (sight.sin_elevation * field.tile_m), 1.0f);
  color = mix(color, litter_radiance(field.mean_albedo), (1.0f - crossing) * exp(-optical_depth));
  return pack_radiance(hazed(tinted_tier(color * color_factor, kStripTint), haze_at(from_eye_m)));
}

// A place on the boundary of a tile, in shares of its side; counter-clockwise from the south-west corner.
vec2 boundary_place(int side, float along) {
  return side == 0 ? vec2(along, 0.0f)
                   : (side == 1 ? vec2(1.0f, along)
                                : (side == 2 ? vec2(1.0f - along, 1.0f) : vec2(0.0f, 1.0f - along)));
}

// Densities lie at the middles of cells.
float density_at(vec2 place, vec4 density_per_m2) {
  vec2 between = clamp(2.0f * place - 0.5f, 0.0f, 1.0f);
  return mix(mix(density_per_m2.x, density_per_m2.y, between.x),
             mix(density_per_m2.z, density_per_m2.w, between.x), between.y);
}

// The ground's normal, by the tile's corners.
vec3 tile_normal(int first, float side_m) {
  vec4 south_m = uintBitsToFloat(texelFetch(tile_texels, first + 4));
  vec4 east_m = uintBitsToFloat(texelFetch(tile_texels, first + 5));
  vec4 west_m = uintBitsToFloat(texelFetch(tile_texels, first + 7));
  return normalized(vec3(south_m.x - east_m.x, south_m.x - west_m.x, side_m));
}

// How a strip stands at a column: where a share of 1 of its height lies from the foot, and how far the sward
// leans.
struct Stance {
  vec3 upward;
  vec2 lean;
};

Stance stance_at(vec2 from_eye_m, uint species, vec4 traits) {
  Stance stance = Stance(vec3(0.0f, 0.0f, 1.0f), vec2(0.0f));
#ifdef MOVING
  vec3 swayed = swayed_tip(swaying_at(from_eye_m, species));
  stance.upward = vec3(0.0f, 0.0f, 1.0f) + (traits.z + traits.w * length(swayed.xy)) * swayed;
  stance.lean = stance.upward.xy;
#ifdef TRODDEN
  Pressing pressing = pressing_at(from_eye_m);
  float lying = lying_share(pressing);
  stance.upward = normalized(stance.upward * (1.0f - lying) + vec3(pressing.lean_rad, 0.03f)) *
                  (worn_length(pressing.wear) * sqrt(inner(stance.upward, stance.upward)));
  stance.lean += lean_of(pressing);
#endif
#endif
  return stance;
}

// Of the texture: the species' layer for the face that is seen, south, east, north or west.
float layer_of(uint species, int side, vec3 foot_m) {
  bool is_east_west = (side & 1) == 0;
  int facing = is_east_west ? (foot_m.y > 0.0f ? 0 : 2) : (foot_m.x > 0.0f ? 3 : 1);
  return float(int(species) * 4 + facing);
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= column_count) return;
  uint per_side = quads + 1u;
  uint strip = index / per_side;
  uint column = index - strip * per_side;
  int side = int(strip & 3u);
  int first = int(first_tile + strip / 4u) * kStripTileTexels;
  vec4 a = uintBitsToFloat(texelFetch(tile_texels, first));
  uvec4 b = texelFetch(tile_texels, first + 1);
  vec4 c = uintBitsToFloat(texelFetch(tile_texels, first + 2));
  vec4 density_per_m2 = uintBitsToFloat(texelFetch(tile_texels, first + 3));
  int quarter = int(column) * (kStripQuads / int(quads));
  int point = (side * kStripQuads + quarter) & (kSides * kStripQuads - 1);
  vec4 heights_m = uintBitsToFloat(texelFetch(tile_texels, first + 4 + point / kStripQuads));
  float side_m = a.w;
  float grown = uintBitsToFloat(b.x);
  float blade_height = uintBitsToFloat(b.y);
  uint species_index = b.z;
  SpeciesParams species = load_species(species_index);
  vec4 traits = texelFetch(strip_traits, int(species_index));

  float along = float(quarter) / float(kStripQuads);
  vec2 place = boundary_place(side, along);
  vec3 foot_m = a.xyz + vec3(place * side_m, heights_m[point & (kStripQuads - 1)]);
  float own_per_m2 = density_at(place, density_per_m2);
  float all_per_m2 = own_per_m2 + c.w;
  float standing = traits.x;
  float height_m =
      standing * species.height_m * (1.0f + kTallestSpread * species.height_spread) * blade_height;
  Stance stance = stance_at(foot_m.xy, species_index, traits);
  vec3 color_factor = c.rgb;
#ifdef CONDITIONED
  color_factor *= condition_at(foot_m.xy).rgb;
#endif
  vec3 normal = tile_normal(first, side_m);
  vec3 top_m = foot_m + stance.upward * (height_m * grown);
  uint foot_radiance = radiance_at(foot_m, normal, stance.lean, all_per_m2, height_m * grown, blade_height,
                                   color_factor, species_index);
  uint top_radiance = radiance_at(top_m, normal, stance.lean, all_per_m2, height_m * grown, blade_height,
                                  color_factor, species_index);

  float layer = layer_of(species_index, side, foot_m);
  float shift = unit_from_u32(hash_u32(b.w + uint(side)));
  vec3 from_lod_eye_m = foot_m - view.lod_eye_m;
  float left = 1.0f - sunk_share(view.lod, sqrt(inner(from_lod_eye_m, from_lod_eye_m)));
  float shown = left * min(own_per_m2 / species.densest_per_m2, 1.0f);

  uint texel = 2u * uint(kStripVertexTexels) * (first_column + index);
  vertices[texel] = uvec4(floatBitsToUint(foot_m), foot_radiance);
  vertices[texel + 1u] = floatBitsToUint(vec4(along + shift, standing * (1.0f - grown), layer, shown));
  vertices[texel + 2u] = uvec4(floatBitsToUint(top_m), top_radiance);
  vertices[texel + 3u] = floatBitsToUint(vec4(along + shift, standing, layer, shown));
}
