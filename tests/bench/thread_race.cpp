#include "thread_race.h"

#include "bench_scene.h"
#include "scene_choice.h"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <map>

namespace vkpt::bench {
namespace {

/// Adds the rates of a process of its own with so many threads of lavapipe.
void addRatesOfChild(Rates& rates, const ChildJob& job, int threads) {
  const std::string command = fmt::format(
      "LP_NUM_THREADS={} exec '{}' --child --scenes '{}' --mesh '{}' --size {} --frames {}", threads,
      fs::read_symlink("/proc/self/exe").string(), job.scene, job.mesh.string(), job.size, job.frames);
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr)
    throw Error(ExitCode::Comparison, "cannot start: " + command);
  double wall = 0.0;
  double core = 0.0;
  const int read = std::fscanf(pipe, "%lf %lf", &wall, &core);
  if (pclose(pipe) != 0 || read != 2)
    throw Error(ExitCode::Comparison, "failed: " + command);
  rates.wall.push_back(wall);
  rates.core.push_back(core);
}

/// Processor time of each thread of this process so far.
std::map<std::string, double> secondsOfThreads() {
  std::map<std::string, double> seconds;
  for (const auto& task : fs::directory_iterator("/proc/self/task")) {
    double nanoseconds = 0.0;
    std::ifstream(task.path() / "schedstat") >> nanoseconds;
    seconds[task.path().filename().string()] = 1e-9 * nanoseconds;
  }
  return seconds;
}

/// Of the thread that has had most since `before`: where the machine is busy with other things, all that can
/// be said of how well threads share the work.
double secondsOfBusiestThread(std::map<std::string, double> before) {
  double most = 0.0;
  for (const auto& [thread, seconds] : secondsOfThreads())
    most = std::max(most, seconds - before[thread]);
  return most;
}

} // namespace

Comparison raceThreads(const ChildJob& job, int rounds) {
  Rates one;
  Rates two;
  for (int round = 0; round < rounds; ++round) {
    addRatesOfChild(one, job, 1);
    addRatesOfChild(two, job, 2);
  }
  Comparison c = compare(two, one);
  c.scene = job.scene;
  c.what = "2 threads / 1";
  return c;
}

void runChild(const ChildJob& job) {
  const gpu::Context context;
  DeviceBench scene(context, job.scene, loadByName(job.scene, job.size, job.mesh));
  const auto before = secondsOfThreads();
  const double seconds = scene.render(job.frames);
  const double busy = secondsOfBusiestThread(before);
  const double samples = static_cast<double>(scene.samplesPerRun(job.frames)) * 1e-6;
  fmt::print("{} {}\n", samples / seconds, samples / busy);
}

} // namespace vkpt::bench
