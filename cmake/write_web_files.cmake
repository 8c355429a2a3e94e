# Writes `source`: a C++ file with all files of the folder `pages` (none where that is "") for built_in_web_files().
# The bytes are taken in by the assembler, which does not mind how many they are.
set(names "")
if(pages)
  file(GLOB_RECURSE names RELATIVE ${pages} ${pages}/*)
  list(SORT names)
endif()
set(symbols "")
set(entries "")
set(number 0)
foreach(name ${names})
  set(symbol tetfarm_web_file_${number})
  math(EXPR number "${number} + 1")
  string(APPEND symbols "__asm__(\".section .rodata\\n.balign 16\\n${symbol}:\\n.incbin \\\"${pages}/${name}\\\"\\n"
    "${symbol}_end:\\n.byte 0\\n.previous\\n\");\n"
    "extern \"C\" const char ${symbol}[];\nextern \"C\" const char ${symbol}_end[];\n")
  string(APPEND entries "      {\"${name}\", bytes_between(${symbol}, ${symbol}_end)},\n")
endforeach()
set(text "// Made by cmake/write_web_files.cmake.\n#include \"dashboard/web_pages.h\"\n\n")
if(names)
  string(APPEND text "${symbols}\nnamespace tetfarm {\nnamespace {\n\n"
    "std::string_view bytes_between(const char* begin, const char* end) {\n"
    "  return {begin, static_cast<std::size_t>(end - begin)};\n}\n\n}  // namespace\n\n"
    "std::span<const WebFile> built_in_web_files() {\n  static const WebFile files[] = {\n${entries}  };\n"
    "  return files;\n}\n\n}  // namespace tetfarm\n")
else()
  string(APPEND text "namespace tetfarm {\n\nstd::span<const WebFile> built_in_web_files() { return {}; }\n\n"
    "}  // namespace tetfarm\n")
endif()
if(EXISTS ${source})
  file(READ ${source} old)
endif()
# With files it is written in any case: the compiler has to take in their bytes anew.
if(names OR NOT "${old}" STREQUAL "${text}")
  file(WRITE ${source} "${text}")
endif()
