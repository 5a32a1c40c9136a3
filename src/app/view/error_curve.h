#pragma once
#include "app/view/panel.h"

namespace vkpt {

/// The error over the time, both logarithmic, as a widget of the panel.
void drawErrorCurve(const std::vector<ErrorLook>& looks, std::optional<double> target);

} // namespace vkpt
