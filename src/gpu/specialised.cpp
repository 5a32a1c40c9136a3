#include "gpu/specialised.h"

#include "core/error.h"

#include <optional>
#include <set>
#include <unordered_map>

namespace vkpt::gpu {
namespace {

using Word = std::uint32_t;
using Instruction = std::span<const Word>;

/// Opcodes (SPIR-V 1.5, 3.32).
enum Op : Word {
  kTypeBool = 20,
  kConstantTrue = 41,
  kConstantFalse = 42,
  kConstant = 43,
  kSpecConstantTrue = 48,
  kSpecConstantFalse = 49,
  kSpecConstant = 50,
  kSpecConstantOp = 52,
  kFunction = 54,
  kDecorate = 71,
  kIAdd = 128,
  kISub = 130,
  kIMul = 132,
  kLogicalOr = 166,
  kLogicalAnd = 167,
  kLogicalNot = 168,
  kSelect = 169,
  kIEqual = 170,
  kUGreaterThan = 172,
  kULessThan = 176,
  kShiftRightLogical = 194,
};
constexpr std::size_t kHeaderWords = 5;
constexpr Word kDecorationSpecId = 1;

class Specialiser {
public:
  Specialiser(Instruction spirv, const SpecialisationMap& values) : m_spirv(spirv), m_values(values) {}

  std::vector<Word> result() {
    m_out.assign(m_spirv.begin(), m_spirv.begin() + kHeaderWords);
    m_out.reserve(m_spirv.size());
    std::size_t at = kHeaderWords;
    // Constants stand before the first function.
    while (at < m_spirv.size() && opOf(m_spirv[at]) != kFunction) {
      const std::size_t words = m_spirv[at] >> 16;
      if (words == 0 || at + words > m_spirv.size())
        throw DeviceError("a shader of this build is not SPIR-V");
      add(m_spirv.subspan(at, words));
      at += words;
    }
    m_out.insert(m_out.end(), m_spirv.begin() + static_cast<std::ptrdiff_t>(at), m_spirv.end());
    return std::move(m_out);
  }

private:
  static Word opOf(Word first) { return first & 0xffffU; }

  void add(Instruction i) {
    switch (opOf(i[0])) {
    case kTypeBool:
      m_bools.insert(i[1]);
      break;
    case kDecorate:
      if (i[2] != kDecorationSpecId)
        break;
      if (const auto value = m_values.find(i[3]); value != m_values.end())
        m_set.emplace(i[1], value->second);
      return;
    case kConstantTrue:
    case kSpecConstantTrue:
      return addConstant(i[1], i[2], 1);
    case kConstantFalse:
    case kSpecConstantFalse:
      return addConstant(i[1], i[2], 0);
    case kConstant:
    case kSpecConstant:
      if (i.size() == 4)
        return addConstant(i[1], i[2], i[3]);
      break;
    case kSpecConstantOp:
      if (const auto value = folded(i[3], i.subspan(4)))
        return addConstant(i[1], i[2], *value);
      break;
    default:
      break;
    }
    m_out.insert(m_out.end(), i.begin(), i.end());
  }

  void addConstant(Word type, Word id, Word byDefault) {
    const auto set = m_set.find(id);
    const Word value = set == m_set.end() ? byDefault : set->second;
    m_constants.emplace(id, value);
    if (m_bools.contains(type))
      m_out.insert(m_out.end(), {(3U << 16) | (value != 0 ? kConstantTrue : kConstantFalse), type, id});
    else
      m_out.insert(m_out.end(), {(4U << 16) | kConstant, type, id, value});
  }

  /// Of 32-bit operands and booleans; none where the operation or an operand is not among ours.
  std::optional<Word> folded(Word op, Instruction ids) const {
    std::vector<Word> v;
    for (const Word id : ids) {
      const auto constant = m_constants.find(id);
      if (constant == m_constants.end())
        return std::nullopt;
      v.push_back(constant->second);
    }
    switch (op) {
    case kIAdd:
      return v[0] + v[1];
    case kISub:
      return v[0] - v[1];
    case kIMul:
      return v[0] * v[1];
    case kLogicalOr:
      return v[0] | v[1];
    case kLogicalAnd:
      return v[0] & v[1];
    case kLogicalNot:
      return v[0] ^ 1U;
    case kSelect:
      return v[0] != 0 ? v[1] : v[2];
    case kIEqual:
      return v[0] == v[1];
    case kUGreaterThan:
      return v[0] > v[1];
    case kULessThan:
      return v[0] < v[1];
    case kShiftRightLogical:
      return v[1] < 32 ? v[0] >> v[1] : 0; // further ones have no defined value
    default:
      return std::nullopt;
    }
  }

  Instruction m_spirv;
  const SpecialisationMap& m_values;
  std::vector<Word> m_out;
  std::set<Word> m_bools;                     ///< ids of boolean types
  std::unordered_map<Word, Word> m_set;       ///< values that were given, by the constant's id
  std::unordered_map<Word, Word> m_constants; ///< values by id
};

} // namespace

std::vector<std::uint32_t> specialised(std::span<const std::uint32_t> spirv,
                                       const SpecialisationMap& values) {
  return Specialiser(spirv, values).result();
}

} // namespace vkpt::gpu
