#pragma once
// What guided directions are drawn from: shaders/lib/guide.glsl.

#include "device/packed_scene.h"
#include "shared/structs.h"

#include <span>

namespace vkpt {

/// Light that has come to a diffuse surface by way of specular ones.
struct Photon {
  Vec3f p;           ///< where, in local coordinates
  std::uint32_t bin; ///< of the direction that it came from: guideBinOf()
  float power;       ///< summed over the channels, in any unit
};

struct Guide {
  CubeGrid grid;
  /// For every cube, in the order of guideCube(), where its histogram begins, or kNoGuide; then the
  /// histograms, a number a bin: its share of kAliasUnits (16 bits), threshold and alias of the alias table's
  /// row (8 each). Shares are what the table draws to the last unit.
  std::vector<std::uint32_t> numbers =
      std::vector<std::uint32_t>(4, shared::kNoGuide); // no buffer is smaller
};
/// By the finest of three grids in which a cube has enough photons. One counts in the eight cubes nearest to
/// it, so that neighbours are alike.
Guide makeGuide(std::span<const Photon> photons);

} // namespace vkpt
