#include "app/selftest_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vkpt {
namespace {

using selftest::CaseResult;
using selftest::Figure;
using selftest::Relation;
using selftest::Verdict;

const char* verdictName(Verdict verdict) {
  switch (verdict) {
  case Verdict::Pass:
    return "pass";
  case Verdict::Fail:
    return "FAIL";
  case Verdict::Note:
    return "note";
  }
  return "";
}

/// How much of what is allowed a figure uses; a failing one more than 1, a note nothing.
double share(const Figure& f) {
  if (!f.bound)
    return -1.0;
  if (f.verdict() == Verdict::Fail)
    return std::numeric_limits<double>::infinity();
  const double used = f.relation == Relation::AtMost ? f.value / *f.bound : *f.bound / f.value;
  return std::isfinite(used) ? used : 0.0;
}

std::string boundText(const Figure& f) {
  return f.bound ? fmt::format("{} {:.4g}", f.relation == Relation::AtMost ? "<=" : ">=", *f.bound) : "";
}

std::string row(const std::string& name, const std::string& figure, const std::string& value,
                const std::string& bound, const char* verdict) {
  return fmt::format("{:<24} {:<58} {:>10}  {:<11} {}\n", name, figure, value, bound, verdict);
}

std::string figureRow(const CaseResult& result, const Figure& f) {
  return row(result.which.name, f.name, fmt::format("{:.4g}", f.value), boundText(f),
             verdictName(f.verdict()));
}

nlohmann::json numberOrNull(double x) { return std::isfinite(x) ? nlohmann::json(x) : nlohmann::json(); }

nlohmann::json figureJson(const Figure& f) {
  nlohmann::json j{{"name", f.name},
                   {"value", numberOrNull(f.value)},
                   {"verdict", f.verdict() == Verdict::Fail ? "fail" : verdictName(f.verdict())}};
  if (f.bound) {
    j["bound"] = *f.bound;
    j["relation"] = f.relation == Relation::AtMost ? "<=" : ">=";
  }
  if (!f.detail.empty())
    j["detail"] = f.detail;
  return j;
}

} // namespace

std::size_t SelftestReport::failed() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(results, [](const CaseResult& r) { return !r.passed(); }));
}

std::string caseTableHead() { return row("case", "figure", "value", "bound", "verdict"); }

std::string caseTableRows(const CaseResult& result, bool everything) {
  std::string rows;
  const auto closest = std::ranges::max_element(result.figures, {}, share);
  for (auto f = result.figures.begin(); f != result.figures.end(); ++f) {
    const bool told = f == closest && f->bound; // a note decides nothing
    if (everything || told || f->verdict() == Verdict::Fail)
      rows += figureRow(result, *f);
  }
  if (rows.empty() || (everything && result.conditions > 0)) {
    rows += row(result.which.name, "conditions that held", std::to_string(result.conditions), "",
                result.passed() ? "pass" : "FAIL");
  }
  for (const std::string& failure : result.failures)
    rows += fmt::format("  {}\n", failure);
  return rows;
}

std::string selftestJson(const SelftestReport& report) {
  nlohmann::json cases = nlohmann::json::array();
  for (const CaseResult& r : report.results) {
    nlohmann::json figures = nlohmann::json::array();
    for (const Figure& f : r.figures)
      figures.push_back(figureJson(f));
    cases.push_back({{"name", r.which.name},
                     {"what", r.which.what},
                     {"seconds", r.seconds},
                     {"verdict", r.passed() ? "pass" : "fail"},
                     {"figures", figures},
                     {"conditions", r.conditions},
                     {"failures", r.failures}});
  }
  return nlohmann::json{{"schema", 1},
                        {"device", report.device.name},
                        {"driver", report.device.driver},
                        {"api", report.device.api},
                        {"seed", report.seed},
                        {"seconds", report.seconds},
                        {"passed", report.results.size() - report.failed()},
                        {"failed", report.failed()},
                        {"cases", cases}}
             .dump(2) +
         "\n";
}

std::string caseList() {
  std::string list;
  for (const selftest::Case& c : selftest::allCases())
    list += fmt::format("{:<26} {}\n", c.name, c.what);
  return list;
}

} // namespace vkpt
