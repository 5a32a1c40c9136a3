#pragma once
// The shader library in double: the oracle. Never in one source with program32.h.

#include "host/program_headers.h"

namespace vkpt::host64 {
using Float = double;
#include "host/program.inl"
} // namespace vkpt::host64
