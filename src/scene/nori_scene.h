#pragma once
// Nori scene files: the edition of the course of 2015, and today's.

#include "scene/nori_mesh.h"
#include "scene/nori_xml.h"
#include "scene/scene.h"
#include "scene/sources.h"

namespace vkpt {

/// By its extension, .xml in any case.
bool isNoriFile(const fs::path& file);

/// Throws SceneError: file:line:column, what is wrong, what would be right. A file of tests is refused, too.
Scene loadNoriScene(const SceneText& source, SceneReport& report);

/// One <scene>, which may stand in a test.
Scene readNoriScene(const XmlElement& element, const SceneText& source, NoriMeshFiles& files,
                    SceneReport& report);

} // namespace vkpt
