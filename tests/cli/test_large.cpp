// What takes minutes: ten million triangles, and a million of each degenerate kind.

#include "cli/degenerate_scenes.h"

namespace vkpt::test {
namespace {

constexpr int kMillion = 1000000;

TEST(Large, AMillionTrianglesAtOnePointAreDropped) { expectPointsAreDropped(kMillion); }
TEST(Large, AMillionDuplicatesAreDropped) { expectTwinsAreDropped(kMillion); }
TEST(Large, AMillionSliversAreGivenUpAndSaid) { expectSliversAreGivenUp(kMillion); }
TEST(Large, AMillionConcentricTrianglesAreGivenUpAndSaid) { expectPileIsGivenUp(kMillion); }

TEST(Large, TenMillionTrianglesAreRendered) {
  constexpr int kSquaresAnEdge = 2237; // two triangles each
  const WorkFolder folder;
  const CommandResult r = renderObj(folder, waves(kSquaresAnEdge));
  EXPECT_EQ(r.exitCode, 0) << r.err;
  EXPECT_GT(folder.json("s.json")["deviceBytes"], 10'000'000 * 48); // three texels each
  EXPECT_GT(folder.json("s.json")["mean"][1], 0.4);                 // 0.8 where no wave hides the sky
  tell("wall time", r.seconds, "s");
  tell("resident memory at most", r.peakBytes / 1048576.0, "MiB");
}

} // namespace
} // namespace vkpt::test
