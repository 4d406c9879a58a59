// Memory that is freed and soon needed again.
#pragma once

namespace prairie {

/// From now on the C library keeps freed memory for what comes next, instead of giving it back to the system.
/// Drivers that draw in software ask for some ten megabytes of it in every frame, and finding as many empty
/// pages took a tenth of the frame (docs/measurements.md). Does nothing where the C library cannot be told
/// so. To be called before any other thread runs.
void keep_freed_memory();

}  // namespace prairie
