// Lost contexts: when the graphics device is reset (a hung shader, a driver that restarts, another program's
// fault), all that a context holds is gone, and what it draws from then on is nothing. Contexts are made such
// that OpenGL tells (LOSE_CONTEXT_ON_RESET), where the driver offers it; elsewhere no reset is ever told.
#pragma once

namespace prairie {

enum class GraphicsReset { kNone, kGuilty, kInnocent, kUnknown };

/// Whether the current context has been lost, and whether by its own doing (glGetGraphicsResetStatus).
GraphicsReset graphics_reset();

/// Throws LostContext if the current context has been lost: to be called when a frame or a picture is
/// complete, before anybody takes it for one. `ask` is for tests.
void check_context(GraphicsReset (*ask)() = graphics_reset);

/// Waits until the device has come back, so that a new context can be made, but no longer than two seconds:
/// not every driver tells. The lost context must still be current.
void await_end_of_reset(GraphicsReset (*ask)() = graphics_reset);

}  // namespace prairie
