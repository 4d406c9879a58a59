// libpng and others report a broken file on the standard error stream, past every handler that OpenImageIO
// offers. Within the life of this object that stream leads nowhere: what is wrong is said once, by the typed
// error.
#pragma once

namespace prairie {

/// The stream belongs to the process: another thread's messages of the same moment are lost as well, so keep
/// it short.
class QuietStderr {
 public:
  QuietStderr();
  ~QuietStderr();
  QuietStderr(const QuietStderr&) = delete;
  QuietStderr& operator=(const QuietStderr&) = delete;
};

}  // namespace prairie
