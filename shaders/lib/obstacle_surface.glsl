// What the surfaces of things that stand in the meadow are like, each over one repeat of its texture: for a
// place on it from 0 to 1 the relief (metres) and the albedo. One of BARK, END_GRAIN, GRANITE, BOARDS,
// DRY_STONE is set.
#include "shaders/lib/tiling_noise.glsl"

float ramp(float low, float high, float x) {
  return clamp((x - low) / (high - low), 0.0, 1.0);
}

#ifdef BARK
const vec2 kMapM = vec2(1.2, 1.2);
// Long plates, parted by furrows that run up and join.
float relief_m(vec2 at) {
  vec2 bent = vec2(tiling_noise(at * vec2(7.0, 6.0), ivec2(7, 6), 1u),
                   tiling_noise(at * vec2(30.0, 14.0), ivec2(30, 14), 2u)) -
              0.5;
  vec2 p = at * vec2(26.0, 4.0) + vec2(1.1 * bent.x + 0.45 * bent.y, 0.8 * bent.x);
  float plate = smoothstep(0.0, 0.36, tiling_cells(p, ivec2(26, 4), 3u).x);
  vec2 q = at * vec2(34.0, 22.0) + vec2(1.2 * bent.y, 1.5 * bent.x + 0.9 * bent.y);
  float scales = smoothstep(0.0, 0.30, tiling_cells(q, ivec2(34, 22), 4u).x);
  float rough = tiling_noise(at * vec2(90.0, 48.0), ivec2(90, 48), 5u);
  float fine = tiling_noise(at * vec2(230.0, 110.0), ivec2(230, 110), 6u);
  return 0.012 * plate * (0.60 + 0.20 * scales + 0.20 * rough) + 0.002 * scales + 0.0026 * rough +
         0.0012 * fine;
}
vec3 albedo_at(vec2 at, float height_m) {
  float out_of_furrow = ramp(0.0015, 0.0165, height_m);
  float patchy = tiling_noise(at * vec2(6.0, 3.0), ivec2(6, 3), 7u);
  float fine = tiling_noise(at * vec2(140.0, 80.0), ivec2(140, 80), 8u);
  vec3 albedo = mix(vec3(0.034, 0.026, 0.019), vec3(0.122, 0.102, 0.084), out_of_furrow);
  albedo *= (0.72 + 0.40 * patchy) * (0.82 + 0.36 * fine);
  float patches = 0.55 * tiling_noise(at * vec2(9.0, 8.0), ivec2(9, 8), 9u) +
                  0.45 * tiling_noise(at * vec2(64.0, 60.0), ivec2(64, 60), 10u);
  float lichen = smoothstep(0.60, 0.76, patches) * out_of_furrow;
  return mix(albedo, vec3(0.17, 0.18, 0.15), 0.55 * lichen);
}
#endif

#ifdef END_GRAIN
const vec2 kMapM = vec2(0.5, 0.5);
vec2 polar(vec2 at) {
  vec2 p = at - 0.5;
  return vec2(length(p) * (1.0 + 0.10 * (tiling_noise(at * 5.0, ivec2(5), 1u) - 0.5)), atan(p.y, p.x));
}
float crack(vec2 at, vec2 ray) {
  float wander = ray.y * (11.0 / 6.2831853) + 0.55 * (tiling_noise(at * 9.0, ivec2(9), 2u) - 0.5);
  vec3 own = tiling_values(ivec2(int(floor(wander)), 0), ivec2(11, 1), 3u);
  float beside = abs(fract(wander) - 0.5) * ray.x * (6.2831853 / 11.0);
  float wide = 0.008 * own.x * smoothstep(0.05 + 0.2 * own.y, 0.45, ray.x);
  return 1.0 - smoothstep(wide, wide + 0.006, beside + 0.002);
}
float relief_m(vec2 at) {
  vec2 ray = polar(at);
  float rings = 0.5 + 0.5 * sin(ray.x * 150.0);
  return 0.0015 * rings + 0.001 * tiling_noise(at * 90.0, ivec2(90), 4u) - 0.012 * crack(at, ray);
}
vec3 albedo_at(vec2 at, float height_m) {
  vec2 ray = polar(at);
  float rings = 0.5 + 0.5 * sin(ray.x * 150.0);
  float patchy = tiling_noise(at * 6.0, ivec2(6), 5u);
  vec3 albedo = mix(vec3(0.135, 0.105, 0.074), vec3(0.175, 0.158, 0.134), patchy) * (0.78 + 0.22 * rings);
  albedo *= 0.85 + 0.3 * tiling_noise(at * 120.0, ivec2(120), 6u);
  return albedo * (1.0 - 0.8 * crack(at, ray));
}
#endif

#ifdef GRANITE
const vec2 kMapM = vec2(1.3, 1.3);
float relief_m(vec2 at) {
  float broad = tiling_noise(at * 7.0, ivec2(7), 1u);
  float hollows = tiling_noise(at * 19.0, ivec2(19), 2u);
  float rough = tiling_noise(at * 58.0, ivec2(58), 3u);
  float grain = tiling_noise(at * 170.0, ivec2(170), 4u);
  float pit = smoothstep(0.62, 0.80, tiling_noise(at * 33.0, ivec2(33), 5u));
  float ledge = smoothstep(0.05, 0.30, tiling_cells(at * 6.0 + 0.8 * vec2(hollows, broad), ivec2(6), 6u).x);
  return 0.030 * broad + 0.011 * hollows + 0.0045 * rough + 0.0016 * grain - 0.006 * pit + 0.004 * ledge;
}
vec3 albedo_at(vec2 at, float height_m) {
  float broad = tiling_noise(at * 4.0, ivec2(4), 7u);
  float patchy = tiling_noise(at * 13.0, ivec2(13), 8u);
  vec3 albedo = vec3(0.185, 0.177, 0.164) * (0.70 + 0.36 * broad + 0.24 * patchy);
  float rust = smoothstep(0.5, 0.8, 0.6 * tiling_noise(at * 5.0, ivec2(5), 9u) + 0.4 * patchy);
  albedo *= mix(vec3(1.0), vec3(1.08, 0.94, 0.80), rust);
  // Mica, feldspar and quartz.
  float mica =
      0.5 * tiling_noise(at * 120.0, ivec2(120), 10u) + 0.5 * tiling_noise(at * 220.0, ivec2(220), 11u);
  float feldspar =
      0.5 * tiling_noise(at * 90.0, ivec2(90), 12u) + 0.5 * tiling_noise(at * 190.0, ivec2(190), 13u);
  albedo *= 1.0 - 0.65 * smoothstep(0.58, 0.68, mica);
  albedo = mix(albedo, vec3(0.36, 0.345, 0.325), 0.5 * smoothstep(0.58, 0.70, feldspar));
  // Lichen: pale green crusts, old dark ones, some yellow.
  float ragged = tiling_noise(at * 70.0, ivec2(70), 14u);
  float crust = smoothstep(0.60, 0.66,
                           0.55 * tiling_noise(at * 10.0, ivec2(10), 15u) +
                               0.25 * tiling_noise(at * 27.0, ivec2(27), 16u) + 0.25 * ragged);
  albedo = mix(albedo, vec3(0.27, 0.29, 0.20) * (0.75 + 0.5 * ragged), 0.70 * crust);
  float old_crust = smoothstep(0.58, 0.66, 0.60 * tiling_noise(at * 8.0, ivec2(8), 17u) + 0.35 * ragged);
  albedo = mix(albedo, vec3(0.060, 0.058, 0.052), 0.50 * old_crust);
  float yellow = smoothstep(0.72, 0.80, 0.62 * tiling_noise(at * 17.0, ivec2(17), 18u) + 0.42 * ragged);
  return mix(albedo, vec3(0.27, 0.21, 0.08), 0.45 * yellow);
}
#endif

#ifdef BOARDS
const vec2 kMapM = vec2(2.24, 1.12);
const int kBoards = 8;
float to_joint(vec2 at) {
  float across = fract(at.y * float(kBoards));
  return min(across, 1.0 - across) * kMapM.y / float(kBoards);
}
// Wood grows along the board, and around its knots.
float fibre(vec2 at, float scale, uint seed) {
  int board = int(floor(at.y * float(kBoards)));
  vec3 own = tiling_values(ivec2(board, 1), ivec2(kBoards, 2), 1u);
  vec2 to_knot =
      (fract(at - vec2(own.x, (float(board) + 0.3 + 0.4 * own.y) / float(kBoards)) + 0.5) - 0.5) * kMapM;
  float bend = 0.020 * exp(-dot(to_knot * vec2(9.0, 22.0), to_knot * vec2(9.0, 22.0))) * sign(to_knot.y);
  float wave = 0.010 * (tiling_noise(at * vec2(6.0, 16.0), ivec2(6, 16), 2u) - 0.5);
  return tiling_noise(vec2(at.x * 7.0, (at.y + bend + wave) * scale), ivec2(7, int(scale)), seed);
}
float knot(vec2 at) {
  int board = int(floor(at.y * float(kBoards)));
  vec3 own = tiling_values(ivec2(board, 1), ivec2(kBoards, 2), 1u);
  vec2 to_knot =
      (fract(at - vec2(own.x, (float(board) + 0.3 + 0.4 * own.y) / float(kBoards)) + 0.5) - 0.5) * kMapM;
  return (1.0 - smoothstep(0.6, 1.0, length(to_knot / vec2(0.022, 0.013)))) * step(0.35, own.z);
}
float nail(vec2 at) {
  vec2 p = vec2((abs(fract(at.x * 2.0) - 0.5)) * 0.5 * kMapM.x, to_joint(at) - 0.028);
  return 1.0 - smoothstep(0.004, 0.007, length(p));
}
float relief_m(vec2 at) {
  int board = int(floor(at.y * float(kBoards)));
  vec3 own = tiling_values(ivec2(board, 0), ivec2(kBoards, 2), 3u);
  float height_m = 0.0016 * fibre(at, 240.0, 4u) + 0.002 * fibre(at, 72.0, 5u);
  height_m += 0.010 * smoothstep(0.0015, 0.009, to_joint(at)) + 0.003 * own.x;
  return height_m - 0.002 * nail(at);
}
vec3 albedo_at(vec2 at, float height_m) {
  int board = int(floor(at.y * float(kBoards)));
  vec3 own = tiling_values(ivec2(board, 0), ivec2(kBoards, 2), 6u);
  vec3 albedo =
      mix(vec3(0.215, 0.160, 0.108), vec3(0.205, 0.190, 0.170), 0.30 + 0.70 * own.y) * (0.70 + 0.55 * own.x);
  albedo *= (0.74 + 0.52 * fibre(at, 240.0, 4u)) * (0.72 + 0.56 * fibre(at, 72.0, 5u));
  albedo *= 0.85 + 0.30 * tiling_noise(at * vec2(5.0, 12.0), ivec2(5, 12), 7u);
  albedo = mix(albedo, vec3(0.060, 0.040, 0.026), 0.8 * knot(at));
  albedo = mix(albedo, vec3(0.045, 0.032, 0.026), 0.85 * nail(at));
  return albedo * mix(0.16, 1.0, smoothstep(0.002, 0.0075, to_joint(at)));
}
#endif

#ifdef DRY_STONE
const vec2 kMapM = vec2(1.6, 1.2);
const int kCourses = 9;
const int kStones = 6;

// Where a course begins, in courses, and a stone in its course, in stones.
float course_at(int course) {
  return float(course) + 0.6 * (tiling_values(ivec2(course, 0), ivec2(kCourses, 2), 4u).x - 0.5);
}
float joint_at(int stone, int course) {
  return float(stone) + 0.7 * (tiling_values(ivec2(stone, course), ivec2(kStones, kCourses), 6u).x - 0.5);
}

// How far into its stone a place lies (metres), and a number of the stone.
vec2 stone_at(vec2 at) {
  vec2 broad = at * vec2(14.0, 11.0), ragged = at * vec2(44.0, 33.0);
  vec2 bent =
      0.018 * (vec2(tiling_noise(broad, ivec2(14, 11), 1u), tiling_noise(broad, ivec2(14, 11), 2u)) - 0.5);
  bent += 0.009 *
          (vec2(tiling_noise(ragged, ivec2(44, 33), 15u), tiling_noise(ragged, ivec2(44, 33), 16u)) - 0.5);
  at += bent + vec2(0.0, 0.030 * (tiling_noise(at * vec2(5.0, 1.0), ivec2(5, 1), 3u) - 0.5));
  // Courses of unlike height, each joint shifted by itself.
  float place = at.y * float(kCourses);
  int course = int(floor(place));
  float low = course_at(course);
  float high = course_at(course + 1);
  if (place < low) {
    course -= 1;
    high = low;
    low = course_at(course);
  } else if (place >= high) {
    course += 1;
    low = high;
    high = course_at(course + 1);
  }
  float along = at.x * float(kStones) + tiling_values(ivec2(course, 1), ivec2(kCourses, 2), 5u).x * 3.0;
  int stone = int(floor(along));
  float left = joint_at(stone, course);
  float right = joint_at(stone + 1, course);
  if (along < left) {
    stone -= 1;
    right = left;
    left = joint_at(stone, course);
  } else if (along >= right) {
    stone += 1;
    left = right;
    right = joint_at(stone + 1, course);
  }
  // Some are two flat ones.
  vec3 own = tiling_values(ivec2(stone, course), ivec2(kStones, kCourses), 7u);
  if (own.y > 0.62) {
    float middle = mix(low, high, 0.32 + 0.36 * own.z);
    own.x = place < middle ? own.x : fract(own.x + 0.43);
    if (place < middle) {
      high = middle;
    } else {
      low = middle;
    }
  }
  vec2 inside = vec2(min(along - left, right - along), min(place - low, high - place)) * kMapM /
                vec2(float(kStones), float(kCourses));
  // Corners are round.
  const float kRoundM = 0.036;
  vec2 from_round = max(kRoundM - inside, 0.0);
  float depth_m = kRoundM - length(from_round);
  return vec2(depth_m, own.x);
}
float relief_m(vec2 at) {
  vec2 stone = stone_at(at);
  float rough = 0.009 * tiling_noise(at * vec2(40.0, 30.0), ivec2(40, 30), 8u) +
                0.0025 * tiling_noise(at * vec2(120.0, 90.0), ivec2(120, 90), 9u);
  return 0.022 * smoothstep(-0.004, 0.022, stone.x) + 0.016 * stone.y + rough;
}
vec3 albedo_at(vec2 at, float height_m) {
  vec2 stone = stone_at(at);
  vec3 own = tiling_values(ivec2(int(stone.y * 4096.0), 0), ivec2(4096, 1), 10u);
  vec3 albedo = mix(vec3(0.165, 0.160, 0.150), vec3(0.215, 0.180, 0.138), own.x) * (0.55 + 0.70 * own.y);
  albedo *= 0.78 + 0.44 * tiling_noise(at * vec2(24.0, 18.0), ivec2(24, 18), 11u);
  albedo *= 0.84 + 0.32 * tiling_noise(at * vec2(150.0, 112.0), ivec2(150, 112), 12u);
  float ragged = tiling_noise(at * vec2(80.0, 60.0), ivec2(80, 60), 13u);
  float crust =
      smoothstep(0.62, 0.70, 0.70 * tiling_noise(at * vec2(13.0, 10.0), ivec2(13, 10), 14u) + 0.32 * ragged);
  albedo = mix(albedo, vec3(0.25, 0.26, 0.21), 0.6 * crust);
  return albedo * mix(0.12, 1.0, smoothstep(-0.004, 0.007, stone.x));
}
#endif
