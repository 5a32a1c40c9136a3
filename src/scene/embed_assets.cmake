# cmake -DOUTPUT=... -DASSETS=folder -DNAMES=a.obj,b.mtl -DFUNCTION=name -DHEADER=file.h -P embed_assets.cmake
# Writes a C++ file that holds the named text files and is what vkpt::FUNCTION(), declared in HEADER, returns.
string(REPLACE "," ";" names "${NAMES}")
set(entries "")
foreach(name IN LISTS names)
  file(READ "${ASSETS}/${name}" text)
  string(FIND "${text}" ")vkpt\"" terminator)
  if(NOT terminator EQUAL -1)
    message(FATAL_ERROR "${ASSETS}/${name} holds the end of a raw string, )vkpt\"")
  endif()
  string(APPEND entries "    {\"${name}\", R\"vkpt(${text})vkpt\"sv},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Made by embed_assets.cmake.
#include \"${HEADER}\"

namespace vkpt {

using namespace std::string_view_literals; // without the suffix Clang counts the characters itself, for minutes

namespace {
constexpr EmbeddedAsset kAssets[] = {
${entries}};
} // namespace

std::span<const EmbeddedAsset> ${FUNCTION}() { return kAssets; }

} // namespace vkpt
")
