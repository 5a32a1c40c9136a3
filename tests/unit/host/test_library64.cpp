#include "host/program64.h"
#include "unit/host/mesh_scene.h"
#include "unit/host/random.h"

#include <array>
#include <numbers>

#include <gtest/gtest.h>

#define SUITE(Name) Host64##Name
namespace vkpt::host64 {
#include "unit/host/library_tests.inl"
} // namespace vkpt::host64
