// A shader program as it is needed for grass that stands still, sways or has been trodden, and for grass that
// something has come over. Each is made when it is first asked for: compiling is what takes longest when the
// program starts.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "render/gl/gl_objects.h"
#include "world/motion.h"

namespace prairie {

enum class GrassMotion { kStill, kSwaying, kTrodden };

/// What drawing grass takes.
struct GrassVariant {
  GrassMotion motion = GrassMotion::kStill;
  bool conditioned = false;  // conditions (animation/condition.h) may change its colour and stiffness
};

/// For this world as it is now.
GrassVariant grass_variant(const Motion& motion);

class MovingProgram {
 public:
  /// As for make_program; `defines` are set besides those of the variant.
  MovingProgram(std::filesystem::path folder, std::vector<std::string> names,
                std::vector<std::string> defines = {});

  /// Throws NoSuitableOpenGl, BadInput when it has to be made.
  GLuint get(GrassVariant variant);

 private:
  std::filesystem::path folder_;
  std::vector<std::string> names_;
  std::vector<std::string> defines_;
  std::array<GlProgram, 6> programs_;
};

}  // namespace prairie
