// The exit codes of the program; scripts rely on them.
#pragma once

namespace prairie {

inline constexpr int kExitFine = 0;
inline constexpr int kExitFailure = 1;      // unwritable output, full disk, memory budget, difference found
inline constexpr int kExitUsage = 2;        // every error of the command line
inline constexpr int kExitBadInput = 3;     // bad, missing or unreadable input
inline constexpr int kExitNoOpenGl = 4;     // no suitable OpenGL
inline constexpr int kExitSignalled = 128;  // + the signal's number: 130 after Ctrl-C

}  // namespace prairie
