#pragma once
// tinyobjloader in double precision, private to this library.

#define TINYOBJLOADER_USE_DOUBLE
// A name of our own: a program that links vkpt and Debian's float build of tinyobjloader must not mix the
// two.
#define tinyobj vkpt_tinyobj
#include <tiny_obj_loader.h>
#undef tinyobj
