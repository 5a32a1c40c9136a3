// Degenerate scenes of a size that CI can take; test_large.cpp has a million of each.

#include "cli/degenerate_scenes.h"

namespace vkpt::test {
namespace {

constexpr int kCount = 20000;

TEST(Degenerate, TrianglesAtOnePointAreDropped) { expectPointsAreDropped(kCount); }
TEST(Degenerate, ExactDuplicatesAreDropped) { expectTwinsAreDropped(kCount); }
TEST(Degenerate, SliversAboutOnePointAreSeen) { expectSliversAreSeen(kCount); }
TEST(Degenerate, WhatCannotBeLookedAtIsSaid) { expectPileIsGivenUp(2 * kCount); }

} // namespace
} // namespace vkpt::test
