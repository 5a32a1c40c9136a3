#pragma once
#include "scene/sources.h"

namespace vkpt {

/// Text files of shaders/lib, by name.
std::span<const EmbeddedAsset> embeddedShaders();

} // namespace vkpt
