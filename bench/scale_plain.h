// The least that drawing triangles can cost: positions as they are, one colour. What the frame of a meadow is
// held against.
#pragma once

#include "lod/camera.h"
#include "render/gl/gl_objects.h"

namespace prairie {

/// Takes positions as seen from the eye along the scene's axes as vertex attribute 0 and has the matrix
/// clip_from_eye as uniform 0. Throws NoSuitableOpenGl.
GlProgram make_plain_program();

/// Binds and clears the framebuffer, and sets depth test and camera for the program.
void begin_plain(GLuint program, GLuint framebuffer, const Camera& camera);

}  // namespace prairie
