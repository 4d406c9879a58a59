// The sphere unfolded onto a square by an octahedron (Cigolle et al. 2014, A Survey of Efficient
// Representations for Independent Unit Vectors).

vec2 octahedral_place(vec3 direction) {
  vec3 n = direction / (abs(direction.x) + abs(direction.y) + abs(direction.z));
  vec2 folded = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
  return 0.5 + 0.5 * (n.z >= 0.0 ? n.xy : folded);
}

vec3 octahedral_direction(vec2 place) {
  vec2 e = 2.0 * place - 1.0;
  float z = 1.0 - abs(e.x) - abs(e.y);
  vec2 folded = (1.0 - abs(e.yx)) * vec2(e.x >= 0.0 ? 1.0 : -1.0, e.y >= 0.0 ? 1.0 : -1.0);
  return normalize(vec3(z >= 0.0 ? e : folded, z));
}
