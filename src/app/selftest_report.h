#pragma once
// What the cases of `vkpt selftest` found, for people and for scripts.

#include "selftest/case.h"

#include <string>
#include <vector>

namespace vkpt {

struct SelftestReport {
  gpu::DeviceInfo device;
  std::uint32_t seed = 0;
  double seconds = 0.0;
  std::vector<selftest::CaseResult> results;
  [[nodiscard]] std::size_t failed() const;
};

std::string caseTableHead();
/// Lines of the table: the figure that is closest to its bound and those that fail; or, `everything`, all.
std::string caseTableRows(const selftest::CaseResult& result, bool everything);
std::string selftestJson(const SelftestReport& report);
/// Every case and what holds in it.
std::string caseList();

} // namespace vkpt
