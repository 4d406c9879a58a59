// What all passes know: of the eye, of the light, of the field.
layout(std140, binding = kViewBlock) uniform ViewBlock {
  ViewParams view;
};
layout(std140, binding = kLightBlock) uniform LightBlock {
  LightParams light;
};
layout(std140, binding = kFieldBlock) uniform FieldBlock {
  FieldParams field;
};
