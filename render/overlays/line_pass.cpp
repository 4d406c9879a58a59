#include "render/overlays/line_pass.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>
#include <vector>

#include "lod/frustum.h"
#include "render/gl/shader_program.h"
#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

constexpr GLsizei kVerticesPerLine = 6;
constexpr float kShownWhereHidden = 0.12f;
constexpr float kWidthOfHeight = 1.0f / 480.0f;  // of the picture's
constexpr float kThinnestPx = 1.5f;

}  // namespace

LinePass::LinePass(std::filesystem::path shader_folder)
    : shader_folder_(std::move(shader_folder)), no_vertices_(make_vertex_array("lines")) {}

bool LinePass::prepare(StreamBuffer& stream, std::span<const LineSegment> lines, const Camera& camera) {
  count_ = 0;
  if (lines.empty()) return false;
  const Frustum frustum(camera);
  std::vector<LineParams> seen;
  for (const LineSegment& line : lines) {
    if (!frustum.may_see({glm::min(line.from_m, line.to_m), glm::max(line.from_m, line.to_m)})) continue;
    LineParams params{};
    params.start_from_eye_m = glm::vec3(line.from_m - camera.eye_m);
    params.end_from_eye_m = glm::vec3(line.to_m - camera.eye_m);
    params.color = line.color;
    seen.push_back(params);
  }
  count_ = seen.size();
  if (count_ == 0) return false;
  table_ = stream.write(seen.data(), count_ * sizeof(LineParams));
  size_px_ = glm::vec2(camera.size_px);
  if (program_.get() == 0) program_ = make_program(shader_folder_, {"pass/line.vert", "pass/line.frag"});
  return true;
}

void LinePass::draw() {
  if (count_ == 0) return;
  const GLuint program = program_.get();
  glUseProgram(program);
  glBindVertexArray(no_vertices_.get());
  bind_storage(layouts::kThingBuffer, table_);
  glProgramUniform2f(program, layouts::kLineSize, size_px_.x, size_px_.y);
  glProgramUniform1f(program, layouts::kLineHalfWidth,
                     0.5f * std::max(kWidthOfHeight * size_px_.y, kThinnestPx));
  for (const auto& [state, share] : {std::pair(kHiddenState, kShownWhereHidden), std::pair(kState, 1.0f)}) {
    set_draw_state(state);
    glProgramUniform1f(program, layouts::kOverlayShown, share);
    glDrawArrays(GL_TRIANGLES, 0, kVerticesPerLine * static_cast<GLsizei>(count_));
  }
}

}  // namespace prairie
