# The shared library that every FMU carries, built beside the program: the functions of FMI, and of the modules what they
# need. It exports these functions alone. Of other libraries it takes fmt, xxHash and the C++ library into itself, so
# that a host may have others; Bullet, of which Debian has no archives, lies beside it in the FMU.
if(NOT CMAKE_SYSTEM_NAME STREQUAL "Linux" OR NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  return()
endif()
add_library(floes_fmu_library MODULE $<TARGET_OBJECTS:floes_fmi>)
target_link_libraries(floes_fmu_library PRIVATE floes_fmi)
set_target_properties(floes_fmu_library PROPERTIES PREFIX "" OUTPUT_NAME floes_fmu LINKER_LANGUAGE CXX
                      BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH "$ORIGIN")
file(WRITE ${PROJECT_BINARY_DIR}/generated/fmu_exports.map "{ global: fmi2*; fmi3*; local: *; };\n")
target_link_options(floes_fmu_library PRIVATE LINKER:--version-script=${PROJECT_BINARY_DIR}/generated/fmu_exports.map
                    LINKER:--disable-new-dtags LINKER:--gc-sections LINKER:--as-needed LINKER:-s)
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  target_link_options(floes_fmu_library PRIVATE -static-libstdc++ -static-libgcc LINKER:-z,defs)
endif()
if(TARGET floes_cli)
  add_dependencies(floes_cli floes_fmu_library)
endif()
