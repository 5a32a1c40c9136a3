// Prints how long trees take to build and what they are like: time_accel [threads...]

#include "core/clock.h"
#include "unit/accel/bvh_check.h"
#include "unit/accel/exact_sweep.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace vkpt;

double bestMilliseconds(const std::vector<Box3f>& boxes, unsigned threads) {
  double best = 1e30;
  for (int i = 0; i < 5; ++i) {
    const Stopwatch watch;
    buildBvh(boxes, {.threads = threads});
    best = std::min(best, watch.seconds());
  }
  return 1e3 * best;
}

void report(const test::NamedMesh& m, const std::vector<unsigned>& threads) {
  const std::vector<Box3f> boxes = test::boxesOf(m.mesh);
  const Bvh bvh = buildBvh(boxes);
  const auto sizes = test::leafSizes(bvh);
  std::printf("%-22s %8zu triangles, %7zu nodes, depth %2u, leaves of 1-4: %zu %zu %zu %zu, cost %.2f;",
              m.name.c_str(), boxes.size(), bvh.nodes.size(), bvh.depth, sizes[0], sizes[1], sizes[2],
              sizes[3], test::expectedCost(bvh, 1.0));
  for (const unsigned t : threads)
    std::printf("  %u threads %.1f ms", t, bestMilliseconds(boxes, t));
  std::printf("\n");
}

} // namespace

int main(int argc, char** argv) {
  std::vector<unsigned> threads;
  for (int i = 1; i < argc; ++i)
    threads.push_back(static_cast<unsigned>(std::strtoul(argv[i], nullptr, 10)));
  if (threads.empty())
    threads = {1, 2};
  report({"waves", test::waves(224)}, threads);
  report({"waves", test::waves(708)}, threads);
  report({"soup", test::soup(1'000'000, 0.01F, "soup")}, threads);
  report({"coincident", test::coincident(1'000'000)}, threads);
  report({"geometric", test::geometric(1'000'000, 1.00008)}, threads);
  report({"sliver fan", test::sliverFan(1'000'000)}, threads);
  return 0;
}
