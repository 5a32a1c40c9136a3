// Specialisation constants become constants.
#include "gpu/specialised.h"
#include "spirv.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

using Words = std::vector<std::uint32_t>;

Words instruction(std::uint32_t op, const Words& operands) {
  Words words{(static_cast<std::uint32_t>(operands.size() + 1) << 16) | op};
  words.insert(words.end(), operands.begin(), operands.end());
  return words;
}

/// A header, then the instructions. Result ids: bool 1, uint 2.
Words module(const std::vector<Words>& instructions) {
  Words words{0x07230203, 0x00010500, 0, 100, 0};
  for (const Words& i : instructions)
    words.insert(words.end(), i.begin(), i.end());
  return words;
}

const Words kBool = instruction(20, {1});
const Words kUint = instruction(21, {2, 32, 0});
const Words kFunction = instruction(54, {2, 90, 0, 91});

Words decorated(std::uint32_t id, std::uint32_t specId) { return instruction(71, {id, 1, specId}); }

TEST(Specialised, ValuesThatAreGivenReplaceDefaults) {
  const Words before =
      module({decorated(10, 0), decorated(11, 7), decorated(12, 9), kBool, kUint, instruction(48, {1, 10}),
              instruction(50, {2, 11, 5}), instruction(49, {1, 12}), kFunction});
  const Words defaults = module({kBool, kUint, instruction(41, {1, 10}), instruction(43, {2, 11, 5}),
                                 instruction(42, {1, 12}), kFunction});
  EXPECT_EQ(gpu::specialised(before, {}), defaults);
  EXPECT_EQ(gpu::specialised(before, {{3, 1}}), defaults) << "an id that the module lacks";
  EXPECT_EQ(gpu::specialised(before, {{0, 0}, {7, 8}, {9, 1}}),
            module({kBool, kUint, instruction(42, {1, 10}), instruction(43, {2, 11, 8}),
                    instruction(41, {1, 12}), kFunction}));
}

TEST(Specialised, OperationsOnThemAreConstantsToo) {
  struct Case {
    std::uint32_t op;
    Words operands;
    std::uint32_t type, value;
  };
  // Ids: 10 true, 11 false, 12 is 3, 13 is 4.
  const std::vector<Case> cases{
      {128, {12, 13}, 2, 7},     {132, {12, 13}, 2, 12},    {166, {10, 11}, 1, 1}, {166, {11, 11}, 1, 0},
      {167, {10, 11}, 1, 0},     {167, {10, 10}, 1, 1},     {168, {10}, 1, 0},     {168, {11}, 1, 1},
      {169, {10, 12, 13}, 2, 3}, {169, {11, 12, 13}, 2, 4}, {170, {12, 13}, 1, 0}, {170, {12, 12}, 1, 1},
      {172, {12, 13}, 1, 0},     {172, {13, 12}, 1, 1},     {172, {12, 12}, 1, 0}, {130, {13, 12}, 2, 1},
      {194, {13, 10}, 2, 2},     {176, {12, 13}, 1, 1},     {176, {13, 12}, 1, 0}, {176, {12, 12}, 1, 0}};
  const std::vector<Words> constants{kBool,
                                     kUint,
                                     instruction(41, {1, 10}),
                                     instruction(42, {1, 11}),
                                     instruction(43, {2, 12, 3}),
                                     instruction(43, {2, 13, 4})};
  for (const Case& c : cases) {
    std::vector<Words> before = constants, after = constants;
    Words operation{c.type, 20, c.op};
    operation.insert(operation.end(), c.operands.begin(), c.operands.end());
    before.push_back(instruction(52, operation));
    after.push_back(c.type == 2 ? instruction(43, {2, 20, c.value})
                                : instruction(c.value != 0 ? 41 : 42, {1, 20}));
    EXPECT_EQ(gpu::specialised(module(before), {}), module(after)) << "operation " << c.op;
  }
}

TEST(Specialised, AnOperationThatIsNotOursStays) {
  const Words before = module({kUint, instruction(43, {2, 10, 3}), instruction(52, {2, 11, 134, 10, 10})});
  EXPECT_EQ(gpu::specialised(before, {}), before);
}

TEST(Specialised, NothingIsLeftOfThemInOurKernels) {
  for (const std::span<const std::uint32_t> kernel :
       {spirv::kPath, spirv::kFirstVertices, spirv::kSharePaths, spirv::kCommit}) {
    const Words code = gpu::specialised(kernel, {});
    for (std::size_t at = 5; at < code.size(); at += code[at] >> 16) {
      const std::uint32_t op = code[at] & 0xffffU;
      ASSERT_FALSE(op >= 48 && op <= 52) << "word " << at << ": opcode " << op;
      ASSERT_GT(code[at] >> 16, 0U);
    }
  }
}

} // namespace
} // namespace vkpt::test
