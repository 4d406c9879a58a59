#include "bench/scale_plain.h"

#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <string>

#include "files/error.h"
#include "render/gl/draw_state.h"

namespace prairie {
namespace {

constexpr const char* kVertexText = R"(#version 450 core
layout(location = 0) in vec3 position_m;
layout(location = 0) uniform mat4 clip_from_eye;
void main() { gl_Position = clip_from_eye * vec4(position_m, 1.0f); }
)";
constexpr const char* kFragmentText = R"(#version 450 core
layout(location = 0) out vec4 color;
void main() { color = vec4(0.2f, 0.4f, 0.1f, 1.0f); }
)";

void attach_stage(GLuint program, GLenum kind, const char* text) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // goes with the program
}

}  // namespace

GlProgram make_plain_program() {
  GlProgram program(glCreateProgram());
  attach_stage(program.get(), GL_VERTEX_SHADER, kVertexText);
  attach_stage(program.get(), GL_FRAGMENT_SHADER, kFragmentText);
  glLinkProgram(program.get());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    std::array<char, 1024> log{};
    glGetProgramInfoLog(program.get(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw NoSuitableOpenGl("", "the plain program", log.data(), "a driver that takes it");
  }
  return program;
}

void begin_plain(GLuint program, GLuint framebuffer, const Camera& camera) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, camera.size_px.x, camera.size_px.y);
  set_draw_state({});
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClearDepth(0.0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const glm::mat4 clip_from_eye = camera.clip_from_eye();
  glProgramUniformMatrix4fv(program, 0, 1, GL_FALSE, glm::value_ptr(clip_from_eye));
  glUseProgram(program);
}

}  // namespace prairie
