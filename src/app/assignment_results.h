#pragma once
// What an assignment's run has made: the page is written from it.

#include "app/assignment_pictures.h"
#include "app/run_report.h"
#include "study/study_report.h"

#include <vector>

namespace vkpt {

struct DrawnPicture {
  const AssignmentPicture* picture = nullptr;
  RunReport report;
};

struct DoneExperiment {
  const AssignmentExperiment* experiment = nullptr;
  StudySection section;
};

struct AssignmentResults {
  Sheet sheet = Sheet::A;
  std::vector<DrawnPicture> pictures; ///< those that are finished, in the list's order
  std::vector<DoneExperiment> experiments;
  std::string command;
  bool complete = true; ///< else interrupted, or only some were asked for
};

/// index.html in the folder where the pictures are, and all that it shows: the experiments' plots, and the
/// annotated pictures.
void writeAssignmentPage(const fs::path& folder, const AssignmentResults& results);

} // namespace vkpt
