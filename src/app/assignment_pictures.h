#pragma once
// The pictures and experiments that the two assignments ask for: the one list of them.

#include <cstdint>
#include <span>
#include <string_view>

namespace vkpt {

enum class Sheet { A, B };

struct AssignmentPicture {
  std::string_view name;      ///< of its files: "a-blocks"
  std::string_view part;      ///< of the sheet: "A 1"
  std::string_view caption;   ///< what it shows
  std::uint32_t samples = 0;  ///< for every pixel; 0: kEqualSeconds of rendering
  std::string_view arguments; ///< of vkpt, with blanks between
};

/// A study, see vkpt study.
struct AssignmentExperiment {
  std::string_view name; ///< of its folder
  std::string_view title;
  std::string_view arguments; ///< of vkpt study, with blanks between
};

/// Of a picture without a number of samples, at full quality.
inline constexpr double kEqualSeconds = 20.0;

std::span<const AssignmentPicture> picturesOf(Sheet sheet);
std::span<const AssignmentExperiment> experimentsOf(Sheet sheet);

} // namespace vkpt
