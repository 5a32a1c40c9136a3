#pragma once
// The self-test's statistics of films, under the tests' names.

#include "selftest/statistics.h"

namespace vkpt::test {
using namespace selftest;
}
