// The float program against the double one: the same paths, but for the few that rounding parts.

#include "unit/host/boxes.h"
#include "unit/host/image_difference.h"

#include "core/hash.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

constexpr int kSize = 32;
constexpr int kFrames = 16;

class HostParity : public testing::TestWithParam<BoxParity> {};

TEST_P(HostParity, FloatAndDoubleWalkTheSamePaths) {
  const auto seed = static_cast<std::uint32_t>(hashText("HostParity" + std::string(GetParam().box)));
  const CornellScene box = cornellBox(GetParam().box, kSize, seed);
  const HostRender a = renderHost32(box.packed, box.scene, box.effects, box.settings, kFrames);
  const HostRender b = renderHost64(box.packed, box.scene, box.effects, box.settings, kFrames);
  EXPECT_EQ(a.counters.faults(), 0U);
  EXPECT_EQ(b.counters.faults(), 0U);
  const PartedPaths limit = partedPaths(GetParam().partedInDouble, kSize * kSize * kFrames);
  const ImageDifference d = differenceOf(a.film, b.film);
  EXPECT_LE(d.pixels, limit.most);
  EXPECT_LE(d.meanOverSe, limit.meanOverSe);
}

INSTANTIATE_TEST_SUITE_P(Boxes, HostParity, testing::ValuesIn(kBoxParities),
                         [](const auto& box) { return std::string(box.param.box); });

TEST(HostRender, DoesNotDependOnThreads) {
  const CornellScene box = cornellBox("spheres", 16, 1);
  const HostRender one = renderHost32(box.packed, box.scene, box.effects, box.settings, 20, 1);
  const HostRender three = renderHost32(box.packed, box.scene, box.effects, box.settings, 20, 3);
  EXPECT_EQ(one.counters.raysClosest, three.counters.raysClosest);
  EXPECT_EQ(one.counters.raysShadow, three.counters.raysShadow);
  for (std::size_t i = 0; i < one.film.pixels.size(); ++i) {
    ASSERT_EQ(one.film.pixels[i].count, 20U);
    ASSERT_EQ(one.film.pixels[i].mean, three.film.pixels[i].mean);
    ASSERT_EQ(one.film.pixels[i].m2, three.film.pixels[i].m2);
  }
}

TEST(HostRender, EffectsOfNoUseChangeNothing) {
  CornellScene box = cornellBox("blocks", 16, 2);
  const HostRender lean = renderHost64(box.packed, box.scene, box.effects, box.settings, 4);
  for (const Effect e :
       {Effect::Mirror, Effect::Glass, Effect::Metal, Effect::Background, Effect::BounceLimit})
    box.effects.set(e);
  const HostRender full = renderHost64(box.packed, box.scene, box.effects, box.settings, 4);
  for (std::size_t i = 0; i < lean.film.pixels.size(); ++i)
    ASSERT_EQ(lean.film.pixels[i].mean, full.film.pixels[i].mean);
}

} // namespace
} // namespace vkpt::test
