# cmake -DOUTPUT=... -DASSETS=folder -DNAMES=a.obj,b.mtl -P embed_assets.cmake
# Writes a C++ file that holds the named text files and is what vkpt::embeddedAssets() returns.
string(REPLACE "," ";" names "${NAMES}")
set(entries "")
foreach(name IN LISTS names)
  file(READ "${ASSETS}/${name}" text)
  string(FIND "${text}" ")vkpt\"" terminator)
  if(NOT terminator EQUAL -1)
    message(FATAL_ERROR "${ASSETS}/${name} holds the end of a raw string, )vkpt\"")
  endif()
  string(APPEND entries "    {\"${name}\", R\"vkpt(${text})vkpt\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Made from assets/ by embed_assets.cmake.
#include \"scene/sources.h\"

namespace vkpt {

namespace {
constexpr EmbeddedAsset kAssets[] = {
${entries}};
} // namespace

std::span<const EmbeddedAsset> embeddedAssets() { return kAssets; }

} // namespace vkpt
")
