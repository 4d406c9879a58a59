// A shader program as it is needed for grass that stands still, sways or has been trodden. Each is made when it is first asked
// for: compiling is what takes longest when the program starts.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "render/gl_objects.h"
#include "world/motion.h"

namespace prairie {

enum class GrassMotion { kStill, kSwaying, kTrodden };

/// What drawing this world takes now.
GrassMotion grass_motion(const Motion& motion);

class MovingProgram {
 public:
  /// As for make_program; `defines` are set besides those of the motion.
  MovingProgram(std::filesystem::path folder, std::vector<std::string> names, std::vector<std::string> defines = {});

  /// Throws NoSuitableOpenGl, BadInput when it has to be made.
  GLuint get(GrassMotion motion);

 private:
  std::filesystem::path folder_;
  std::vector<std::string> names_;
  std::vector<std::string> defines_;
  std::array<GlProgram, 3> programs_;
};

}  // namespace prairie
