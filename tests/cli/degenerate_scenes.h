#pragma once
// Scenes on which a build could go deep and a traversal without end: what the command makes of them.

#include "cli/command.h"
#include "cli/small_scenes.h"
#include "film/image.h"

#include <gtest/gtest.h>

namespace vkpt::test {

/// Renders the scene at 32 x 32 under a white sky, in a wall of time that is far above what it takes.
inline CommandResult renderObj(const WorkFolder& folder, const std::string& obj) {
  folder.write("x.obj", obj);
  CommandSettings settings{folder.path(), {}};
  settings.patience = 900.0;
  return vkpt({"x.obj", "--frames", "2", "--size", "32x32", "--background", kWhite, "--max-bounces", "1",
               "--stats", "s.json", "-o", "x.exr"},
              settings);
}

inline float centreOf(const WorkFolder& folder) {
  const Image image = readImage(folder / "x.exr");
  return image.channels[0].values[static_cast<std::size_t>(image.width) * 16 + 16];
}

/// All of it but kSquare has no area.
inline void expectPointsAreDropped(int count) {
  const WorkFolder folder;
  const CommandResult r = renderObj(folder, atOnePoint(count));
  EXPECT_EQ(r.exitCode, 0) << r.err;
  EXPECT_EQ(folder.json("s.json")["droppedDegenerate"], count);
  EXPECT_FLOAT_EQ(centreOf(folder), 0.8F);
}

/// One is left.
inline void expectTwinsAreDropped(int count) {
  const WorkFolder folder;
  const CommandResult r = renderObj(folder, identical(count));
  EXPECT_EQ(r.exitCode, 0) << r.err;
  EXPECT_EQ(folder.json("s.json")["droppedDuplicates"], count - 1);
  EXPECT_EQ(r.warnings().size(), 1U) << r.err;
}

inline void expectSliversAreSeen(int count) {
  const WorkFolder folder;
  const CommandResult r = renderObj(folder, sliverFan(count));
  EXPECT_EQ(r.exitCode, 0) << r.err;
  EXPECT_FLOAT_EQ(centreOf(folder), 0.8F);
}

/// Rays that pass their common point would meet more of them than a traversal may look at.
inline void expectSliversAreGivenUp(int count) {
  const WorkFolder folder;
  const CommandResult r = renderObj(folder, sliverFan(count));
  EXPECT_EQ(r.exitCode, 5) << r.err;
  const auto stats = folder.json("s.json");
  EXPECT_GT(stats["faults"]["cutTraversal"], 0);
  EXPECT_EQ(stats["faults"]["nonFinite"], 0);
}

/// More in one place than a traversal may look at: it ends, and says what it gave up.
inline void expectPileIsGivenUp(int count) {
  const WorkFolder folder;
  const CommandResult r = renderObj(folder, concentric(count));
  EXPECT_EQ(r.exitCode, 5) << r.err;
  EXPECT_GT(folder.json("s.json")["faults"]["cutTraversal"], 0);
  EXPECT_FLOAT_EQ(centreOf(folder), 0.8F); // what it had found is the same surface
}

} // namespace vkpt::test
