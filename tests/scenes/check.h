#pragma once
// Named checks of the kernels: each renders a scene whose answer is known. The tests run them on the shipped
// kernels, where they must hold, and on mutated ones, where at least one must not.

#include "scenes/render_fixture.h"
#include "scenes/scene_builder.h"

#include <string>

namespace vkpt::test {

/// One run of a check: what it renders with, and what it found wrong.
class Trial {
public:
  Trial(std::string check, const Kernel& kernel) : m_check(std::move(check)), m_kernel(kernel) {}

  [[nodiscard]] const Kernel& kernel() const { return m_kernel; }
  /// Fills in the kernel and, where it is 0, the seed: a hash of the check's name and the render's number.
  [[nodiscard]] RenderSetup complete(RenderSetup setup);
  /// Renders; a counted fault is a failure.
  Rendered render(const Scene& scene, const RenderSetup& setup);

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

  [[nodiscard]] const std::vector<std::string>& failures() const { return m_failures; }
  [[nodiscard]] const std::vector<Film>& pictures() const { return m_pictures; }

private:
  /// A standard error below a third of the bias that is to be seen. Noise of a mutated kernel proves nothing.
  void demandCalm(double error, double bias, const std::string& figures);

  std::string m_check;
  Kernel m_kernel;
  int m_renders = 0;
  std::vector<std::string> m_failures;
  std::vector<Film> m_pictures;
};

struct Check {
  const char* name;
  void (*run)(Trial&);
};

std::span<const Check> lightChecks();
std::span<const Check> materialChecks();
std::span<const Check> pathChecks();
std::span<const Check> filmChecks();
std::span<const Check> deltaChecks();
std::span<const Check> environmentChecks();
std::span<const Check> filterChecks();
std::span<const Check> kindChecks();
std::span<const Check> phongChecks();
std::span<const Check> rouletteChecks();
std::span<const Check> splittingChecks();
std::span<const Check> strategyChecks();
std::span<const Check> surfaceChecks();
/// All of them, cheap ones first.
std::vector<Check> allChecks();
const Check& checkNamed(const std::string& name);

/// A diffuse floor at the origin under a quadrilateral light whose two triangles differ in area, seen as one
/// point; and the radiance it must have.
struct LitFloor {
  Scene scene;
  Vec3d radiance;
};
LitFloor litFloor(double scale = 1.0, const Vec3d& offset = Vec3d(0.0));

/// A closed room with two lights and a block: everything that light sampling and BSDF sampling must agree on.
Scene twoLightRoom();

} // namespace vkpt::test
