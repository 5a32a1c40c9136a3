#include "app/pilot_run.h"

#include "app/expanded_options.h"
#include "app/interrupt.h"
#include "app/status_line.h"
#include "study/pilot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace vkpt {
namespace {

/// Of "--option=value" or "--option", whose value is the next word.
std::string optionOf(const std::string& word) { return word.substr(0, word.find('=')); }

std::vector<std::string> optionsGiven(const std::vector<std::string>& arguments) {
  std::vector<std::string> given;
  for (const auto& word : arguments) {
    if (word.starts_with("--"))
      given.push_back(optionOf(word));
  }
  return given;
}

/// Words of the command with the choices in place of --pilot.
std::vector<std::string> chosenArguments(const std::vector<std::string>& arguments,
                                         const PilotResult& pilot) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (optionOf(arguments[i]) != "--pilot")
      words.push_back(arguments[i]);
    else if (arguments[i].find('=') == std::string::npos)
      ++i; // its value
  }
  for (const PilotTrial& t : pilot.trials) {
    if (!t.kept)
      continue;
    const std::size_t space = t.option.find(' ');
    words.push_back(t.option.substr(0, space));
    words.push_back(t.option.substr(space + 1));
  }
  return words;
}

/// In one line: what was tried, how many times as efficient as what there was, and what was kept.
std::string pilotText(const PilotResult& pilot) {
  std::vector<std::string> trials;
  std::vector<std::string> kept;
  for (const PilotTrial& t : pilot.trials) {
    trials.push_back(fmt::format("{}: {:.2f}", t.option, t.efficiency));
    if (t.kept)
      kept.push_back(t.option);
  }
  if (trials.empty())
    return InterruptGuard::requested() ? "pilot: stopped" : "pilot: nothing to choose in this scene";
  return fmt::format("pilot, {:.1f} s at {}x{}, efficiency over what there was: {}; chosen: {}",
                     pilot.seconds, pilot.width, pilot.height, fmt::join(trials, ", "),
                     kept.empty() ? "nothing else" : fmt::format("{}", fmt::join(kept, " ")));
}

} // namespace

RenderOptions pilotRun(const RenderOptions& o, PreparedRun& p, const gpu::Context& context) {
  PilotPlan plan;
  plan.estimator = p.estimator;
  plan.effectsOf = [&](const EstimatorSettings& e) {
    return compiledEffects(o.effects, detectEffects(p.scene, e));
  };
  plan.fixed = optionsGiven(o.arguments);
  plan.seconds = *o.pilotSeconds;
  plan.seed = o.seed;
  StatusLine line(o.progress);
  const PilotResult pilot = runPilot(context, p.scene, plan, [&](const std::string& what) {
    if (line.isDue())
      line.draw("pilot: " + what);
    return !InterruptGuard::requested();
  });
  RenderOptions chosen = parseCommandLine(chosenArguments(o.arguments, pilot)).render;
  p.estimator = estimatorFor(chosen, p.scene);
  p.detected = detectEffects(p.scene, p.estimator);
  p.effects = compiledEffects(chosen.effects, p.detected);
  p.sceneReport.notes.push_back(pilotText(pilot));
  return chosen;
}

} // namespace vkpt
