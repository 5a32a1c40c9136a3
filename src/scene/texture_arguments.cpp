#include "scene/texture_arguments.h"

#include "scene/statements.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace vkpt {

namespace {

/// Takes `least` words, and up to `most` as long as they are numbers.
struct Option {
  std::string_view name;
  std::size_t least;
  std::size_t most;
  std::array<std::string_view, 2> neutral; ///< values that mean the same as no option; the last one repeats
};

constexpr std::array kOptions{
    Option{"-s", 1, 3, {"1", "1"}},         Option{"-o", 1, 3, {"0", "0"}},
    Option{"-t", 1, 3, {"0", "0"}},         Option{"-mm", 2, 2, {"0", "1"}},
    Option{"-clamp", 1, 1, {"off", "off"}}, Option{"-cc", 1, 1, {"off", "off"}},
    Option{"-blendu", 1, 1, {"on", "on"}},  Option{"-blendv", 1, 1, {"on", "on"}},
    Option{"-bm", 1, 1, {"1", "1"}},        Option{"-boost", 1, 1, {"0", "0"}},
    Option{"-texres", 1, 1, {"", ""}},      Option{"-imfchan", 1, 1, {"", ""}},
    Option{"-type", 1, 1, {"", ""}},
};

bool means(std::string_view word, std::string_view neutral) {
  const auto number = parseNumber(word);
  return word == neutral || (number && number == parseNumber(neutral));
}

bool isNeutral(const Option& option, std::span<const std::string_view> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!means(values[i], option.neutral[std::min<std::size_t>(i, 1)])) {
      return false;
    }
  }
  return true;
}

/// How many of `words` are the option's values; the last word is the file's.
std::size_t countValues(const Option& option, std::span<const std::string_view> words) {
  std::size_t count = 0;
  while (count < option.most && count + 1 < words.size() &&
         (count < option.least || parseNumber(words[count]))) {
    ++count;
  }
  return count;
}

/// Not splitWords(): a '#' starts no comment here, since names may hold it.
std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const auto end = std::min(text.find(' '), text.size());
    if (end > 0) {
      words.push_back(text.substr(0, end));
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

} // namespace

TextureArguments parseTextureArguments(std::string_view arguments) {
  const std::vector<std::string_view> words = wordsOf(arguments);
  TextureArguments parsed;
  std::size_t first = 0;
  while (first < words.size()) {
    const auto option = std::ranges::find(kOptions, words[first], &Option::name);
    if (option == kOptions.end()) {
      break;
    }
    const auto rest = std::span<const std::string_view>(words).subspan(first + 1);
    const std::size_t count = countValues(*option, rest);
    if (!isNeutral(*option, rest.first(count))) {
      parsed.unusedOptions.push_back(option->name);
    }
    first += 1 + count;
  }
  // To the end as it is written, since names may hold blanks.
  if (first < words.size()) {
    parsed.file = arguments.substr(static_cast<std::size_t>(words[first].data() - arguments.data()));
  }
  return parsed;
}

} // namespace vkpt
