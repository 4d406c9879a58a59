// What a vertex of a blade's mesh stands for. Between vertices width and light are linear, and both are
// strongly curved along a blade: a vertex with the values of its own place makes coarse meshes too light and
// too narrow (one segment by a third). So each takes the mean over its part of the blade, weighted as linear
// interpolation does (a hat of half-width h, the length of a segment), by a quadrature with the hat's mean
// and variance: three places at inner vertices, two at the ends.

// Of that quadrature's places along the blade, the outer ones; the third is their middle. Inner vertices: t ±
// h/2.
vec2 places_around(float t, float h) {
  if (t <= 0.0f) return vec2(0.09763107f * h, 0.56903559f * h);
  if (t >= 1.0f) return vec2(1.0f - 0.56903559f * h, 1.0f - 0.09763107f * h);
  return vec2(t - 0.5f * h, t + 0.5f * h);
}

float mean_around(float t, float low, float middle, float high) {
  return (t <= 0.0f || t >= 1.0f) ? 0.5f * (low + high) : (low + middle + high) / 3.0f;
}

// Width of the rib at t, as a share of the widest place. A mesh ends in a point; what the blade's tip covers
// goes to the rib before it.
float mean_profile(float t, float h) {
  if (t >= 1.0f) return 0.0f;
  vec2 places = places_around(t, h);
  float mean = mean_around(t, blade_profile(places.x), blade_profile(t), blade_profile(places.y));
  if (t < 1.0f - 1.5f * h) return mean;
  vec2 tip = places_around(1.0f, h);
  float tip_mean = mean_around(1.0f, blade_profile(tip.x), 0.0f, blade_profile(tip.y));
  return mean + (t <= 0.0f ? 1.0f : 0.5f) * tip_mean;
}

// Mean of l⁶ (shaders/kernels/lighting.glsl) around a rib, over the blade's length, not its area: l⁶ counts
// where it is crowded, and there one sees the tips.
float mean_power6(float t, float h) {
  vec2 places = places_around(t, h);
  return mean_around(t, power6(places.x), power6(t), power6(places.y));
}

// Where along the blade a rib has its colour from: in a single triangle, whose foot is wide, not from the
// foot.
float mean_place(float t, float h) {
  return (t <= 0.0f && h >= 1.0f) ? 0.125f : t;
}

// Meshes have 8, 4, 2 or 1 segments, each the one before without its odd vertices, so that one can take the
// shape of the next before the next takes its place. A mesh serves blades of so many pixels or more.
float least_pixels(int segments) {
  return segments >= 8 ? 240.0f : (segments >= 4 ? 80.0f : (segments >= 2 ? 34.0f : 0.0f));
}

// Where every blade is asked for, as what others are compared with, meshes are finer.
float mesh_pixels(LodCoefficients lod, float blade_pixels) {
  return lod.unthinned > 0.5f ? 20.0f * blade_pixels : blade_pixels;
}

// How far a blade's mesh has taken the shape of the mesh with half as many segments, 0…1.
float coarser_share(LodCoefficients lod, int segments, float blade_pixels) {
  if (segments <= 1) return 0.0f;
  return 1.0f - smooth_ramp(2.5f * (mesh_pixels(lod, blade_pixels) / least_pixels(segments) - 1.0f));
}

// The same of a rib that both meshes have.
float blended_profile(float t, float h, float coarser) {
  return lerp(mean_profile(t, h), mean_profile(t, min(2.0f * h, 1.0f)), coarser);
}
float blended_power6(float t, float h, float coarser) {
  return lerp(mean_power6(t, h), mean_power6(t, min(2.0f * h, 1.0f)), coarser);
}
float blended_place(float t, float h, float coarser) {
  return lerp(mean_place(t, h), mean_place(t, min(2.0f * h, 1.0f)), coarser);
}

// A bent blade as one sees it, across the line of sight: its area and those of its chords, for a width of
// one.
struct SeenAreas {
  float blade;
  float four;  // chords
  float two;
  float one;
};

float length_across(vec3 v, vec3 to_eye) {
  vec3 turned_v = outer(v, to_eye);
  return sqrt(inner(turned_v, turned_v));
}

// From the blade's points at quarters of its length. What chords fall short by falls with the square of their
// number.
SeenAreas seen_areas(vec3 p0, vec3 p1, vec3 p2, vec3 p3, vec3 p4, vec3 to_eye) {
  float w1 = blade_profile(0.125f);
  float w2 = blade_profile(0.375f);
  float w3 = blade_profile(0.625f);
  float w4 = blade_profile(0.875f);
  SeenAreas seen;
  seen.four = w1 * length_across(p1 - p0, to_eye) + w2 * length_across(p2 - p1, to_eye) +
              w3 * length_across(p3 - p2, to_eye) + w4 * length_across(p4 - p3, to_eye);
  seen.two = 0.5f * ((w1 + w2) * length_across(p2 - p0, to_eye) + (w3 + w4) * length_across(p4 - p2, to_eye));
  seen.one = 0.25f * (w1 + w2 + w3 + w4) * length_across(p4 - p0, to_eye);
  seen.blade = seen.four + (seen.four - seen.two) / 3.0f;
  return seen;
}

float chords_seen(SeenAreas seen, int segments) {
  return segments >= 8 ? lerp(seen.blade, seen.four, 0.25f)
                       : (segments >= 4 ? seen.four : (segments >= 2 ? seen.two : seen.one));
}

// By what a mesh must be wider than the blade for both to cover the same.
float wider_for_chords(SeenAreas seen, int segments, float coarser) {
  float own = chords_seen(seen, segments);
  float next = chords_seen(seen, max(segments / 2, 1));
  return min(seen.blade / max(lerp(own, next, coarser), 1.0e-6f), 2.0f);
}
