#pragma once
// The self-test's scenes made in code, under the tests' names.

#include "selftest/scene_builder.h"

namespace vkpt::test {
using namespace selftest;
}
