#pragma once
// --pilot: what is worth most in a scene is tried before it is rendered.

#include "app/render_run.h"

namespace vkpt {

/// The options of a render without --pilot, with what its pilot has chosen in place of it; `prepared` follows
/// them. Options that were given stay. Tells what was tried, and adds it to the notes for the record of the
/// run.
RenderOptions pilotRun(const RenderOptions& options, PreparedRun& prepared, const gpu::Context& context);

} // namespace vkpt
