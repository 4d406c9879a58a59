#include "render/overlays/field_overlay_pass.h"

#include <utility>
#include <vector>

#include "render/gl/shader_program.h"

namespace prairie {
namespace {

constexpr GLuint kTableBinding = 5;
constexpr std::array<const char*, 4> kDefines{"", "WIND_ARROWS", "TILT_HEAT", "RECOVERY_HEAT"};
constexpr GLsizei kVerticesPerArrow = 18;  // an outline, and the arrow on it
constexpr GLsizei kVerticesPerSquare = 6;
constexpr float kShownWhereHidden = 0.3f;

}  // namespace

FieldOverlayPass::FieldOverlayPass(std::filesystem::path shader_folder)
    : shader_folder_(std::move(shader_folder)), no_vertices_(make_vertex_array()) {}

void FieldOverlayPass::prepare(StreamBuffer& stream, const World& world, glm::dvec3 eye_m,
                               FieldOverlay overlay) {
  shown_ = overlay;
  count_ = 0;
  const auto upload = [&](const auto& entries) {
    count_ = entries.size();
    if (count_ > 0) table_ = stream.write(entries.data(), count_ * sizeof(entries.front()));
  };
  if (overlay == FieldOverlay::kNone) return;
  if (overlay == FieldOverlay::kWind) {
    upload(wind_arrows(world, eye_m));
  } else {
    upload(heat_squares(world, eye_m, overlay));
  }
  GlProgram& program = programs_[static_cast<std::size_t>(overlay)];
  if (program.get() != 0) return;
  program = make_program(shader_folder_, {"pass/field_overlay.vert", "pass/field_overlay.frag"},
                         {kDefines[static_cast<std::size_t>(overlay)]});
}

void FieldOverlayPass::draw() {
  if (count_ == 0) return;
  const GLuint program = programs_[static_cast<std::size_t>(shown_)].get();
  glUseProgram(program);
  glBindVertexArray(no_vertices_.get());
  glBindBufferRange(GL_SHADER_STORAGE_BUFFER, kTableBinding, table_.buffer, table_.offset, table_.bytes);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  const GLsizei vertices = shown_ == FieldOverlay::kWind ? kVerticesPerArrow : kVerticesPerSquare;
  // Depth is reversed: the less is the farther.
  for (const auto& [test, share] : {std::pair(GL_LESS, kShownWhereHidden), std::pair(GL_GEQUAL, 1.0f)}) {
    glDepthFunc(test);
    glProgramUniform1f(program, 0, share);
    glDrawArraysInstanced(GL_TRIANGLES, 0, vertices, static_cast<GLsizei>(count_));
  }
  glDisable(GL_BLEND);
}

}  // namespace prairie
