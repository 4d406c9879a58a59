// Programs from the files of shaders/, whose #include lines are followed here (each file once).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/gl/gl_objects.h"

namespace prairie {

/// The text of `folder`/`name` (name begins with "shaders/"-relative path, e.g. "pass/pose.comp") with its
/// includes put in. Throws BadInput for a file that is not there.
std::string shader_source(const std::filesystem::path& folder, const std::string& name);

/// Compiles and links, with the preprocessor names `defines` set (empty ones are none); the kind of each
/// stage follows from its suffix (.vert, .frag, .comp). Throws NoSuitableOpenGl with the driver's message if
/// it refuses them.
GlProgram make_program(const std::filesystem::path& folder, const std::vector<std::string>& names,
                       const std::vector<std::string>& defines = {});

}  // namespace prairie
