# floes_assets(TARGET FUNCTION files…): puts files into a module, which reads them by name:
# std::optional<std::string_view> FUNCTION(std::string_view name). A change of a file builds its object again.
function(floes_assets target function)
  if(NOT TARGET ${target})
    return()
  endif()
  set(number 0)
  foreach(file ${ARGN})
    get_filename_component(path ${file} ABSOLUTE)
    get_filename_component(name ${file} NAME)
    list(APPEND paths ${path})
    string(APPEND FLOES_ASSET_TEXTS
      "asm(\".section .rodata\\n.balign 16\\nfloes_${function}_${number}:\\n.incbin \\\"${path}\\\"\\nfloes_${function}_${number}_end:\\n.previous\");\n")
    string(APPEND FLOES_ASSET_SYMBOLS "extern const char floes_${function}_${number}[], floes_${function}_${number}_end[];\n")
    string(APPEND FLOES_ASSET_LINES
      "    if (name == \"${name}\") return text(floes_${function}_${number}, floes_${function}_${number}_end);\n")
    math(EXPR number "${number} + 1")
  endforeach()
  set(FLOES_ASSET_FUNCTION ${function})
  set(source ${PROJECT_BINARY_DIR}/generated/${target}_assets.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/assets.cpp.in ${source} @ONLY)
  # -fno-lto: link-time optimisation does not see the symbols of assembler.
  set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS "${paths}" COMPILE_OPTIONS -fno-lto)
  target_sources(${target} PRIVATE ${source})
endfunction()
