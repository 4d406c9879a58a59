// Everything that a decoder process does for a world: see WorldOptions::decoder.
//
//   WorkerProcess decoder(decoding_work());                    // at the beginning of main, before any thread
//   WorkerProcess decoder("/usr/bin/prairie", kDecodeArgument);  // or the program's, at any time
#pragma once

#include "files/worker_process.h"

namespace prairie {

/// What makes `prairie` a decoder that does what its standard input, a WorkerProcess, asks for.
inline constexpr const char* kDecodeArgument = "decode-for-parent";

Work decoding_work();

}  // namespace prairie
