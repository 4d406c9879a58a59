#include "render/moving_program.h"

#include "render/shader_program.h"

namespace prairie {

GrassMotion grass_motion(const Motion& motion) {
  if (motion.treading().bytes() > 0) return GrassMotion::kTrodden;
  return motion.sway() ? GrassMotion::kSwaying : GrassMotion::kStill;
}

MovingProgram::MovingProgram(std::filesystem::path folder, std::vector<std::string> names,
                             std::vector<std::string> defines)
    : folder_(std::move(folder)), names_(std::move(names)), defines_(std::move(defines)) {}

GLuint MovingProgram::get(GrassMotion motion) {
  GlProgram& program = programs_[static_cast<std::size_t>(motion)];
  if (program.get() == 0) {
    std::vector<std::string> defines = defines_;
    if (motion != GrassMotion::kStill) defines.push_back("MOVING");
    if (motion == GrassMotion::kTrodden) defines.push_back("TRODDEN");
    program = make_program(folder_, names_, defines);
  }
  return program.get();
}

}  // namespace prairie
