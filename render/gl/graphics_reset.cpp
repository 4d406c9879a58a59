#include "render/gl/graphics_reset.h"

#include <epoxy/gl.h>

#include <chrono>
#include <string>
#include <thread>

#include "files/error.h"

namespace prairie {
namespace {

constexpr std::chrono::seconds kLongestReset(2);
constexpr std::chrono::milliseconds kBetweenQuestions(20);

std::string cause_of(GraphicsReset reset) {
  switch (reset) {
    case GraphicsReset::kGuilty:
      return "which this drawing caused";
    case GraphicsReset::kInnocent:
      return "which another program caused";
    default:
      return "whose cause is unknown";
  }
}

}  // namespace

GraphicsReset graphics_reset() {
  switch (glGetGraphicsResetStatus()) {
    case GL_NO_ERROR:
      return GraphicsReset::kNone;
    case GL_GUILTY_CONTEXT_RESET:
      return GraphicsReset::kGuilty;
    case GL_INNOCENT_CONTEXT_RESET:
      return GraphicsReset::kInnocent;
    default:
      return GraphicsReset::kUnknown;
  }
}

void check_context(GraphicsReset (*ask)()) {
  const GraphicsReset reset = ask();
  if (reset == GraphicsReset::kNone) return;
  throw LostContext("", "OpenGL", "a reset of the graphics device, " + cause_of(reset),
                    "one that keeps running; try again, or a smaller --size, --set lod.quality=low, another "
                    "--device");
}

void await_end_of_reset(GraphicsReset (*ask)()) {
  const auto start = std::chrono::steady_clock::now();
  while (ask() != GraphicsReset::kNone && std::chrono::steady_clock::now() - start < kLongestReset)
    std::this_thread::sleep_for(kBetweenQuestions);
}

}  // namespace prairie
