#pragma once
// A scene as plain data: what the loaders make and everything else reads. Immutable once loaded.

#include "core/error.h"
#include "core/math.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace vkpt {

/// How a surface scatters. The values are those of `shaders/shared/materials.h`.
enum class BsdfType : std::uint32_t { Diffuse = 0, Mirror = 1, Dielectric = 2, Conductor = 3 };

struct Material {
  std::string name;
  SourceLocation where;
  BsdfType bsdf = BsdfType::Diffuse;
  Vec3f reflectance{0.5F}; ///< Diffuse: albedo; Mirror: reflectance. Linear RGB, [0, inf).
  Vec3f emission{0.0F};    ///< Radiance of the front side, W m^-2 sr^-1.
  float intIor = 1.5F;     ///< Dielectric: index behind the surface (opposite to the normal).
  float extIor = 1.0F;     ///< Dielectric: index in front of the surface.
  Vec3f eta{1.0F};         ///< Conductor: real part of the index of refraction, per channel.
  Vec3f k{0.0F};           ///< Conductor: imaginary part.
};

inline constexpr std::uint32_t kNoNormal = 0xFFFFFFFFU;

/// Counterclockwise seen from the front. Indices into Scene::positions and Scene::normals.
struct Triangle {
  std::array<std::uint32_t, 3> vertex;
  std::array<std::uint32_t, 3> normal{kNoNormal, kNoNormal, kNoNormal}; ///< all three or none
  std::uint32_t material = 0;
};

/// A perspective pinhole camera in world coordinates (before recentring).
struct Camera {
  enum class FovAxis { Horizontal, Vertical };
  Vec3d eye{0.0};
  Vec3d target{0.0, 0.0, -1.0};
  Vec3d up{0.0, 1.0, 0.0};
  double fovDegrees = 45.0; ///< the full angle along `fovAxis`
  FovAxis fovAxis = FovAxis::Horizontal;
};

struct Scene {
  std::string name;             ///< for metadata and default file names, e.g. "CornellBox+CornellBlocks"
  Vec3d origin{0.0};            ///< world position of the local coordinates' origin (recentred in double)
  std::vector<Vec3f> positions; ///< relative to `origin`
  std::vector<Vec3f> normals;   ///< unit length
  std::vector<Triangle> triangles;
  std::vector<Material> materials;
  Camera camera;
  Vec3f background{0.0F}; ///< radiance of rays that leave the scene
  int width = 512;
  int height = 512;
  int defaultFrames = 64;
};

/// What a loader tells the user: conventions applied, and what was odd.
struct SceneReport {
  std::vector<std::string> notes;    ///< "Cornell rule: x0.025, turned, camera fitted"
  std::vector<std::string> warnings; ///< each names file:line and what was done about it
  std::size_t droppedDegenerate = 0; ///< triangles of zero area
  std::size_t inventedNormals = 0;   ///< vertices given a smooth normal
};

} // namespace vkpt
