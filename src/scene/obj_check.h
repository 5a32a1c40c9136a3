#pragma once
// The syntax of OBJ statements: tinyobjloader reads a malformed number as 0 and says nothing.

#include "scene/obj_reader.h"
#include "scene/sources.h"

#include <string>
#include <vector>

namespace vkpt {

/// Throws SceneError at the first statement that is malformed: a word that is no number, too few of them, a
/// vertex that is not finite or out of range, an index that is 0 or no integer. Returns the `mtllib`
/// statements.
std::vector<ObjMaterialUse> checkObj(const SceneText& source, std::vector<std::string>& warnings);

} // namespace vkpt
