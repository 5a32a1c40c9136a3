// The one place where tinyobjloader's code is compiled.
#define TINYOBJLOADER_IMPLEMENTATION
#include "scene/tinyobj.h"
