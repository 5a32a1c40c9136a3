#pragma once
// The report of a study: files that open offline.

#include "film/image.h"
#include "study/study_analysis.h"

#include <string>

namespace vkpt {

/// What the report says beside the figures.
struct StudyFacts {
  std::string command; ///< as it was typed
  std::string scene;
  std::string folder; ///< of its files within the report's, where there are several scenes
  std::string device;
  std::string kinds;         ///< of light path that were judged; empty: all
  std::string referenceName; ///< how the reference came about
  double loadSeconds = 0.0;
  double compileSeconds = 0.0;
  DisplaySettings display;
};

/// What was studied of one scene.
struct StudySection {
  StudyFacts facts;
  StudyResult result;
};

/// Throws UsageError unless gnuplot can be started: to be called before rendering.
void checkGnuplot();

/// Error against time and against frames, into `folder`: error-time and error-frames, .svg and .png each, and
/// the script that drew them. Throws Error with what gnuplot could not do.
void drawPlots(const fs::path& folder, const std::vector<SettingSummary>& summaries);

/// results.csv: a line for every point that was measured.
std::string resultsCsv(const StudyResult& result);
/// results.json: the facts, the summaries and the points; of several scenes an array of these.
std::string resultsJson(const std::vector<StudySection>& sections);

/// What is worth knowing before the figures: why the study stopped, what its reference can tell, which
/// settings are biased.
std::vector<std::string> remarks(const StudyResult& result, const std::vector<SettingSummary>& summaries);

/// The plots and pictures of one scene, into `folder`, and the HTML that shows them, its tables and what is
/// worth knowing: a <section class=study> for a page with kReportStyle and kReportScript.
std::string studySection(const fs::path& folder, const StudySection& section);

/// All of the above, then report.html, which holds plots, tables and pictures in itself. Each of several
/// scenes has its files in a folder of its own in `folder`, which exists.
void writeReport(const fs::path& folder, const std::vector<StudySection>& sections);

} // namespace vkpt
