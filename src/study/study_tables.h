#pragma once
// The tables of a report, as HTML.

#include "study/study_analysis.h"

#include <string>

namespace vkpt {

/// "1.23 %"
std::string percent(double share);

/// Error at equal time and equal samples, time to equal errors, slopes and energy.
std::string mainTables(const StudyResult& result, const std::vector<SettingSummary>& summaries);

/// What leaving something out saves and loses, against the first setting.
std::string ablationTable(const std::vector<SettingSummary>& summaries);

/// What the settings that bias lack, and the error that no time takes from them; empty where none does.
std::string biasTable(const StudyResult& result, const std::vector<SettingSummary>& summaries);

/// One scene's settings in a line each, for a table of several scenes: scene, setting, errors, efficiency.
std::vector<std::vector<std::string>> overviewRows(const std::string& scene, const StudyResult& result,
                                                   const std::vector<SettingSummary>& summaries);
std::vector<std::string> overviewHead();

} // namespace vkpt
