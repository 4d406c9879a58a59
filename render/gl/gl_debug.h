// What the driver says of the way it is used: OpenGL's debug messages (KHR_debug), recorded for whoever asks.
// Drivers say most in a debug context (ContextOptions::debug), in others perhaps nothing.
#pragma once

#include <epoxy/gl.h>

#include <string>
#include <vector>

namespace prairie {

enum class GlSeverity { kNotification, kLow, kMedium, kHigh };

struct GlMessage {
  GLuint id = 0;  // the driver's own numbering
  GlSeverity severity = GlSeverity::kNotification;
  std::string text;
};

/// "high 1282: GL_INVALID_OPERATION in …", on one line.
std::string line_of(const GlMessage& message);

/// Records the messages of the context that is current when it is made, as long as it lives; that context has
/// to be current when it is destroyed, too. A context has one log at most: the newest.
class GlMessageLog {
 public:
  GlMessageLog();
  ~GlMessageLog();
  GlMessageLog(const GlMessageLog&) = delete;
  GlMessageLog& operator=(const GlMessageLog&) = delete;

  /// In the order in which they came. Each comes before the call that caused it returns.
  const std::vector<GlMessage>& messages() const { return messages_; }
  /// Those of medium or high severity: errors, undefined or deprecated behaviour, serious loss of speed.
  std::vector<GlMessage> faults() const;
  void clear() { messages_.clear(); }

 private:
  std::vector<GlMessage> messages_;
};

}  // namespace prairie
