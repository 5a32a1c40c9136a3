#pragma once
// Whether tables choose lights as well as the tree does: part of light_grid.h.

#include "device/light_grid.h"

namespace vkpt {

/// Of a scene whose tables are made: true where they choose about as well as the tree alone, which takes
/// longer (a thousand lights: 1.3 times for a whole sample). By what one light sample brings to some hundred
/// places on the surfaces, unoccluded: the geometric mean of the second moments' ratio, weighted by the light
/// that comes there.
bool tablesChooseAsWell(const PackedScene& scene, const Scene& source, const CubeGrid& grid,
                        const LightGridFunctions& functions);

} // namespace vkpt
