#include "render/gl/gl_debug.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace prairie {
namespace {

GlSeverity severity_of(GLenum severity) {
  switch (severity) {
    case GL_DEBUG_SEVERITY_HIGH:
      return GlSeverity::kHigh;
    case GL_DEBUG_SEVERITY_MEDIUM:
      return GlSeverity::kMedium;
    case GL_DEBUG_SEVERITY_LOW:
      return GlSeverity::kLow;
    default:
      return GlSeverity::kNotification;
  }
}

const char* name_of(GlSeverity severity) {
  switch (severity) {
    case GlSeverity::kHigh:
      return "high";
    case GlSeverity::kMedium:
      return "medium";
    case GlSeverity::kLow:
      return "low";
    case GlSeverity::kNotification:
      break;
  }
  return "notification";
}

void record(GLenum, GLenum, GLuint id, GLenum severity, GLsizei length, const GLchar* text,
            const void* messages) {
  // OpenGL hands the pointer back as it was given, only const.
  auto* const log = static_cast<std::vector<GlMessage>*>(const_cast<void*>(messages));
  log->push_back({id, severity_of(severity),
                  length < 0 ? std::string(text) : std::string(text, static_cast<std::size_t>(length))});
}

}  // namespace

std::string line_of(const GlMessage& message) {
  std::string line = fmt::format("{} {}: {}", name_of(message.severity), message.id, message.text);
  std::ranges::replace(line, '\n', ' ');
  return line;
}

GlMessageLog::GlMessageLog() {
  glEnable(GL_DEBUG_OUTPUT);
  // Otherwise the driver may call from threads of its own, and later.
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(record, &messages_);
}

GlMessageLog::~GlMessageLog() {
  glDebugMessageCallback(nullptr, nullptr);
  glDisable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
}

std::vector<GlMessage> GlMessageLog::faults() const {
  std::vector<GlMessage> faults;
  std::ranges::copy_if(messages_, std::back_inserter(faults),
                       [](const GlMessage& message) { return message.severity >= GlSeverity::kMedium; });
  return faults;
}

}  // namespace prairie
