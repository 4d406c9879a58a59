// A blade's surface at a point of its midrib, as the viewer sees it.

struct BladeSurface {
  vec3 side;  // across the blade, unit length
  vec3 left;  // normals of its two halves, on the viewer's side
  vec3 right;
};

// `along`: derivative of the midrib; `side`: across the blade at rest.
BladeSurface blade_surface(vec3 along, vec3 side, vec3 to_eye) {
  // A blade seen edge-on is turned part of the way towards the eye: it is folded, not a sheet without
  // thickness.
  vec3 facing = normalized(outer(along, to_eye));
  float turn = inner(facing, side) < 0.0f ? -0.45f : 0.45f;
  BladeSurface surface;
  surface.side = normalized(side + facing * turn);
  vec3 normal = normalized(outer(surface.side, along));
  if (inner(normal, to_eye) < 0.0f) normal = -normal;
  // The two halves of a blade are tilted against each other.
  surface.left = normalized(normal - surface.side * 0.5f);
  surface.right = normalized(normal + surface.side * 0.5f);
  return surface;
}
