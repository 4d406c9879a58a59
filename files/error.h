// The typed faults that the world outside can cause: a bad file, an unwritable output, a driver without
// OpenGL 4.5. Broken contracts between functions are not faults; they are asserts.
#pragma once

#include <stdexcept>
#include <string>

namespace prairie {

/// What went wrong with one thing outside the program. `what()` is one line: "FILE: FIELD: found …, expected
/// …".
struct Fault : std::runtime_error {
  /// `file` may be empty where no file is concerned, `field` where the whole file is meant.
  Fault(std::string file, std::string field, std::string found, std::string expected);

  std::string file;
  std::string field;
  std::string found;
  std::string expected;
};

/// An input that is missing, unreadable, malformed or out of range.
struct BadInput : Fault {
  using Fault::Fault;
};

/// An output that could not be written; what stood there before is intact.
struct OutputFailure : Fault {
  using Fault::Fault;
};

/// No OpenGL 4.5 core context could be made; `found` lists every attempt.
struct NoSuitableOpenGl : Fault {
  using Fault::Fault;
};

/// An OpenGL context that there was and that is no more (render/gl/graphics_reset.h).
struct LostContext : NoSuitableOpenGl {
  using NoSuitableOpenGl::NoSuitableOpenGl;
};

/// A byte budget (`--max-memory`) that would be exceeded; raised before the memory is asked for.
struct OverBudget : Fault {
  using Fault::Fault;
};

}  // namespace prairie
