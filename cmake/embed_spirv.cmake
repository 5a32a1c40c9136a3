# Writes the SPIR-V file INPUT as the array vkpt::spirv::VARIABLE into OUTPUT.
file(READ ${INPUT} hex HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1U," words "${hex}")
file(WRITE ${OUTPUT} "#include \"spirv.h\"\n\nnamespace {\nconst std::uint32_t ${VARIABLE}Words[] = {${words}};\n}\n"
  "namespace vkpt::spirv {\nextern const std::span<const std::uint32_t> ${VARIABLE}{${VARIABLE}Words};\n}\n")
