#include "host/program32.h"
#include "unit/host/mesh_scene.h"
#include "unit/host/random.h"

#include <array>
#include <numbers>

#include <gtest/gtest.h>

#define SUITE(Name) Host32##Name
namespace vkpt::host32 {
#include "unit/host/library_tests.inl"
} // namespace vkpt::host32
