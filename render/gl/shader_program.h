// Programs from the files of shaders/, whose #include lines are followed here (each file once).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/gl/gl_objects.h"

namespace prairie {

/// The text of a shader with its includes put in. `#line` directives keep the lines of each file; a file's
/// number in them is its place in `files`.
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;
};

/// `folder`/`name`: a path below shaders/, such as "pass/grow.comp". The preprocessor names `defines` are set
/// (empty ones are none). Throws BadInput for a file that is not there.
ShaderSource shader_source(const std::filesystem::path& folder, const std::string& name,
                           const std::vector<std::string>& defines = {});

/// A compiler's log in which messages name files in place of their numbers ("2:17(5): …" of Mesa, "2(17) : …"
/// of NVIDIA).
std::string log_with_file_names(const std::string& log, const std::vector<std::string>& files);

/// Compiles and links, with the preprocessor names `defines` set (empty ones are none); the kind of each
/// stage follows from its suffix (.vert, .frag, .comp). Throws NoSuitableOpenGl with the driver's message if
/// it refuses them.
GlProgram make_program(const std::filesystem::path& folder, const std::vector<std::string>& names,
                       const std::vector<std::string>& defines = {});

}  // namespace prairie
