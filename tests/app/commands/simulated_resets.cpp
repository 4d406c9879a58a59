// Linked into a copy of the program: answers the first to last question for resets that PRAIRIE_TEST_RESETS
// ("first-last", counted from 1) names as if the graphics device had been reset, the others truly.
#include <epoxy/gl.h>

#include <cstdio>
#include <cstdlib>

namespace {

// What libepoxy's pointer to the driver's function held: at first, a function that looks the driver's up.
using Ask = decltype(epoxy_glGetGraphicsResetStatus);
Ask the_driver = nullptr;
int questions = 0;
int first = 0;
int last = -1;

GLenum answer();

GLenum true_answer() {
  // That function puts the driver's in its place and calls what stands there, so it must not be this file's.
  epoxy_glGetGraphicsResetStatus = the_driver;
  const GLenum status = glGetGraphicsResetStatus();
  the_driver = epoxy_glGetGraphicsResetStatus;
  epoxy_glGetGraphicsResetStatus = answer;
  return status;
}

GLenum answer() {
  ++questions;
  return questions >= first && questions <= last ? GL_GUILTY_CONTEXT_RESET : true_answer();
}

const bool kTakenOver = [] {
  const char* const range = std::getenv("PRAIRIE_TEST_RESETS");
  if (range == nullptr || std::sscanf(range, "%d-%d", &first, &last) != 2) return false;
  the_driver = epoxy_glGetGraphicsResetStatus;
  epoxy_glGetGraphicsResetStatus = answer;
  return true;
}();

}  // namespace
