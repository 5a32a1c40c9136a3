#pragma once
// Meshes that are hard on triangle tests and trees.

#include "selftest/scene_builder.h"

namespace vkpt::selftest {

/// A closed surface about the origin: `rows` x `columns` of quads, each vertex at a radius between 0.7
/// and 1.3 that is drawn by its number.
struct RoughSphere {
  int rows = 64;
  int columns = 128;

  [[nodiscard]] Vec3d vertex(int row, int column) const;
  void addTo(SceneBuilder& builder, const Material& material) const;
};

/// Triangles of different size about the origin, perpendicular to z: all boxes have one centre.
void addConcentric(SceneBuilder& builder, int count, const Material& material);
/// Triangles of width 1 / count about one point in the plane z = 0, each a radius long.
void addSliverFan(SceneBuilder& builder, int count, double radius, const Material& material);

} // namespace vkpt::selftest
