#include "render/grass/moving_program.h"

#include "render/gl/shader_program.h"

namespace prairie {

GrassVariant grass_variant(const Motion& motion) {
  GrassVariant variant;
  if (motion.sway()) variant.motion = GrassMotion::kSwaying;
  if (motion.treading().bytes() > 0) variant.motion = GrassMotion::kTrodden;
  variant.conditioned = motion.conditions() != nullptr;
  return variant;
}

MovingProgram::MovingProgram(std::filesystem::path folder, std::vector<std::string> names,
                             std::vector<std::string> defines)
    : folder_(std::move(folder)), names_(std::move(names)), defines_(std::move(defines)) {}

GLuint MovingProgram::get(GrassVariant variant) {
  const GrassMotion motion = variant.motion;
  GlProgram& program = programs_[2 * static_cast<std::size_t>(motion) + (variant.conditioned ? 1 : 0)];
  if (program.get() == 0) {
    std::vector<std::string> defines = defines_;
    if (motion != GrassMotion::kStill) defines.push_back("MOVING");
    if (motion == GrassMotion::kTrodden) defines.push_back("TRODDEN");
    if (variant.conditioned) defines.push_back("CONDITIONED");
    program = make_program(folder_, names_, defines);
  }
  return program.get();
}

}  // namespace prairie
