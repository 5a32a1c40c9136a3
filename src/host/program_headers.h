#pragma once
// What program.inl needs, to be included outside of the program's namespace.

#include "device/camera_frame.h"
#include "device/guide.h"
#include "device/packed_scene.h"
#include "film/film.h"
#include "film/splats.h"
#include "host/effect_flags.h"
#include "host/reference.h"
#include "host/replay.h"
#include "shared/structs.h"

#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <type_traits>
#include <vector>

#include <glm/glm.hpp>
#include <glm/packing.hpp>
