#pragma once
// The shader library in float. Only for sources compiled with vkpt_single_precision_literals().

#include "host/program_headers.h"

namespace vkpt::host32 {
using Float = float;
#include "host/program.inl"
} // namespace vkpt::host32
