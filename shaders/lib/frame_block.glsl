layout(std140, binding = 0) uniform FrameBlock {
  FrameParams frame;
};
