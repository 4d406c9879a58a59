// Where the program finds the files that belong to it, installed or in the build tree.
#pragma once

#include <filesystem>

namespace prairie {

/// The folder of the shaders: $PRAIRIE_SHADERS where set, else beside the installed program, else in the
/// sources that the program was built from. Throws BadInput where none of them is there.
std::filesystem::path shader_folder();

}  // namespace prairie
