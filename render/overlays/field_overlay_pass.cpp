#include "render/overlays/field_overlay_pass.h"

#include <utility>
#include <vector>

#include "render/gl/shader_program.h"

namespace prairie {
namespace {

constexpr std::array<const char*, 4> kDefines{"", "WIND_ARROWS", "TILT_HEAT", "RECOVERY_HEAT"};
constexpr GLsizei kVerticesPerArrow = 18;  // an outline, and the arrow on it
constexpr GLsizei kVerticesPerSquare = 6;
constexpr float kShownWhereHidden = 0.3f;

}  // namespace

FieldOverlayPass::FieldOverlayPass(std::filesystem::path shader_folder)
    : shader_folder_(std::move(shader_folder)), no_vertices_(make_vertex_array("field overlay")) {}

bool FieldOverlayPass::prepare(StreamBuffer& stream, const World& world, glm::dvec3 eye_m,
                               FieldOverlay overlay) {
  shown_ = overlay;
  count_ = 0;
  const auto upload = [&](const auto& entries) {
    count_ = entries.size();
    if (count_ > 0) table_ = stream.write(entries.data(), count_ * sizeof(entries.front()));
  };
  if (overlay == FieldOverlay::kNone) return false;
  if (overlay == FieldOverlay::kWind) {
    upload(wind_arrows(world, eye_m));
  } else {
    upload(heat_squares(world, eye_m, overlay));
  }
  GlProgram& program = programs_[static_cast<std::size_t>(overlay)];
  if (program.get() == 0) {
    program = make_program(shader_folder_, {"pass/field_overlay.vert", "pass/field_overlay.frag"},
                           {kDefines[static_cast<std::size_t>(overlay)]});
  }
  return count_ > 0;
}

void FieldOverlayPass::draw() {
  if (count_ == 0) return;
  const GLuint program = programs_[static_cast<std::size_t>(shown_)].get();
  glUseProgram(program);
  glBindVertexArray(no_vertices_.get());
  bind_storage(layouts::kThingBuffer, table_);
  const GLsizei vertices = shown_ == FieldOverlay::kWind ? kVerticesPerArrow : kVerticesPerSquare;
  for (const auto& [state, share] : {std::pair(kHiddenState, kShownWhereHidden), std::pair(kState, 1.0f)}) {
    set_draw_state(state);
    glProgramUniform1f(program, layouts::kOverlayShown, share);
    glDrawArraysInstanced(GL_TRIANGLES, 0, vertices, static_cast<GLsizei>(count_));
  }
}

}  // namespace prairie
