#pragma once
// One run of a check: what it renders with, what it measured, and what it found wrong.

#include "selftest/render_scene.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vkpt::selftest {

enum class Verdict { Pass, Fail, Note };
enum class Relation { AtMost, AtLeast };

/// One number that a check measured.
struct Figure {
  std::string name; ///< "red mean: standard errors off"
  double value = 0.0;
  std::optional<double> bound; ///< none: for information alone
  Relation relation = Relation::AtMost;
  std::string detail; ///< what stands behind the number: "1.002 +- 0.001, expected 1"
  [[nodiscard]] Verdict verdict() const;
};

class Trial {
public:
  /// `seed` is that of the run; each render of each check has numbers of its own.
  Trial(std::string check, const gpu::Context& context, const Kernel& kernel = {}, std::uint32_t seed = 0)
      : m_check(std::move(check)), m_context(context), m_kernel(kernel), m_seed(seed) {}

  /// Runs a check to its end; on a kernel with a mistake no render is begun once that has been noticed.
  void run(const std::function<void(Trial&)>& check);

  [[nodiscard]] const gpu::Context& context() const { return m_context; }
  [[nodiscard]] const Kernel& kernel() const { return m_kernel; }
  /// False on a kernel with a mistake: its noise proves nothing.
  [[nodiscard]] bool isShipped() const { return m_kernel.mutation == 0; }
  /// Of one of several sets of random numbers.
  [[nodiscard]] std::uint32_t seed(const std::string& what) const;
  /// Fills in the kernel and, where it is 0, the seed: a hash of the check's name and the render's number.
  [[nodiscard]] RenderSetup complete(RenderSetup setup);
  /// Renders; a counted fault is a failure.
  Rendered render(const Scene& scene, const RenderSetup& setup);
  /// Renders; the caller looks at the faults.
  Rendered renderFaulty(const Scene& scene, const RenderSetup& setup);

  /// Passes when value <= bound; NaN fails.
  void atMost(const std::string& name, double value, double bound, const std::string& detail = "");
  /// Passes when value >= bound; NaN fails.
  void atLeast(const std::string& name, double value, double bound, const std::string& detail = "");
  /// A figure for information.
  void note(const std::string& name, double value, const std::string& detail = "");
  /// One of many conditions: those that hold are only counted.
  void expect(bool holds, const std::string& what);

  /// The image's mean is within 4 standard errors of `expected`, per channel, and these are below a third of
  /// `tolerance` (relative), so that a bias of that size would show. A channel that should be 0 must be it.
  void expectMean(const Film& film, const Vec3d& expected, double tolerance,
                  const std::string& what = "mean");
  /// Every pixel has the value, to float rounding of `operations` operations, and a variance of exactly 0.
  void expectConstant(const Film& film, const Vec3d& value, int operations, const std::string& what);
  /// No channel of the two images' means differs by more than 4 standard errors; these are below a third of
  /// `tolerance` (relative to b's mean).
  void expectEqualMeans(const Film& a, const Film& b, double tolerance, const std::string& what);
  /// The same bits with as many samples a batch as there can be, and with one: then paths are carried over to
  /// the next dispatch elsewhere. On the shipped kernel enough of them must be. Returns the first render.
  Rendered expectSameWhenCarried(const Scene& scene, RenderSetup setup);

  /// Lines, each with the check's name.
  [[nodiscard]] const std::vector<std::string>& failures() const { return m_failures; }
  [[nodiscard]] const std::vector<Figure>& figures() const { return m_figures; }
  /// Conditions that were looked at by expect().
  [[nodiscard]] std::size_t conditions() const { return m_conditions; }
  [[nodiscard]] const std::vector<Film>& pictures() const { return m_pictures; }

private:
  void add(Figure figure);
  /// A standard error below a third of the bias that is to be seen. Noise of a mutated kernel proves nothing.
  void demandCalm(double error, double bias, const std::string& figures);

  std::string m_check;
  const gpu::Context& m_context;
  Kernel m_kernel;
  std::uint32_t m_seed;
  int m_renders = 0;
  std::size_t m_conditions = 0;
  std::vector<Figure> m_figures;
  std::vector<std::string> m_failures;
  std::vector<Film> m_pictures;
};

} // namespace vkpt::selftest
