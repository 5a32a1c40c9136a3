#pragma once
// Light outside a closed mesh, and whether any of it comes in.

#include "selftest/trial.h"

namespace vkpt::selftest {

/// At least `rays` rays from an eye within a rough sphere, none of which may see the lights outside; and a
/// tenth of them scattered in its folds, shadow rays among them, with next to no light.
void lightOutsideStaysOutside(Trial& t, double rays);

} // namespace vkpt::selftest
