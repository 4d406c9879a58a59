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

constexpr GLuint kTableBinding = 5;
constexpr GLint kShownLocation = 0, kSizeLocation = 1, kHalfWidthLocation = 2;
constexpr GLsizei kVerticesPerLine = 6;
constexpr float kShownWhereHidden = 0.12f;
constexpr float kWidthOfHeight = 1.0f / 480.0f;  // of the picture's
constexpr float kThinnestPx = 1.5f;

}  // namespace

LinePass::LinePass(std::filesystem::path shader_folder)
    : shader_folder_(std::move(shader_folder)), no_vertices_(make_vertex_array()) {}

void LinePass::prepare(StreamBuffer& stream, std::span<const LineSegment> lines, const Camera& camera) {
  count_ = 0;
  if (lines.empty()) return;
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
  if (count_ == 0) return;
  table_ = stream.write(seen.data(), count_ * sizeof(LineParams));
  size_px_ = glm::vec2(camera.size_px);
  if (program_.get() == 0) program_ = make_program(shader_folder_, {"pass/line.vert", "pass/line.frag"});
}

void LinePass::draw() {
  if (count_ == 0) return;
  const GLuint program = program_.get();
  glUseProgram(program);
  glBindVertexArray(no_vertices_.get());
  glBindBufferRange(GL_SHADER_STORAGE_BUFFER, kTableBinding, table_.buffer, table_.offset, table_.bytes);
  glProgramUniform2f(program, kSizeLocation, size_px_.x, size_px_.y);
  glProgramUniform1f(program, kHalfWidthLocation, 0.5f * std::max(kWidthOfHeight * size_px_.y, kThinnestPx));
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  // Depth is reversed: the less is the farther.
  for (const auto& [test, share] : {std::pair(GL_LESS, kShownWhereHidden), std::pair(GL_GEQUAL, 1.0f)}) {
    glDepthFunc(test);
    glProgramUniform1f(program, kShownLocation, share);
    glDrawArrays(GL_TRIANGLES, 0, kVerticesPerLine * static_cast<GLsizei>(count_));
  }
  glDisable(GL_BLEND);
}

}  // namespace prairie
