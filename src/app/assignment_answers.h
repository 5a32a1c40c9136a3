#pragma once
// The parts of an assignment's page: answers, with this run's figures and pictures in them.

#include "app/assignment_results.h"

#include <optional>

namespace vkpt {

/// Gives an answer the pictures and figures that it asks for by name; what was not rendered is a dash.
class AssignmentBook {
public:
  AssignmentBook(const fs::path& folder, const AssignmentResults& results)
      : m_folder(folder), m_results(results) {}

  [[nodiscard]] const RunReport* find(std::string_view name) const;
  [[nodiscard]] std::string samples(std::string_view name) const; ///< "512"
  [[nodiscard]] std::string seconds(std::string_view name) const; ///< "41 s"
  [[nodiscard]] std::string
  error(std::string_view name) const; ///< "1.2 %", "†" where it is not to be trusted
  /// The pictures in a row, each with its caption.
  [[nodiscard]] std::string figures(std::initializer_list<std::string_view> names) const;
  /// Samples, time, rays and error of these pictures, a line each.
  [[nodiscard]] std::string table(std::initializer_list<std::string_view> names) const;
  /// Its study, and null where that was not made.
  [[nodiscard]] const DoneExperiment* experiment(std::string_view name) const;
  /// Plots and tables of the study, for a page; draws them into a folder of its name.
  [[nodiscard]] std::string study(std::string_view name) const;
  [[nodiscard]] const fs::path& folder() const { return m_folder; }

private:
  fs::path m_folder;
  const AssignmentResults& m_results;
};

/// How many times as many samples a setting takes to the error that the first one has; by their errors at
/// equal samples.
std::optional<double> samplesForEqualError(const SettingSummary& first, const SettingSummary& setting);

std::string answersOfA(const AssignmentBook& book);
std::string answersOfB(const AssignmentBook& book);

} // namespace vkpt
