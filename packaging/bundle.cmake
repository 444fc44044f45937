# Read by CPack when the files are in place: makes a tarball that brings all libraries along, the C library and its loader
# too, so that it runs on any Linux of its processor, whatever the machine has; and of the same files a wheel, with the
# Python reader, for pip without root.
set(root ${CPACK_TEMPORARY_DIRECTORY})
set(libraries ${root}/lib)

# start_script(FOLDER LIBRARIES): floes in a folder, with its libraries in another, which is named from the folder above.
function(start_script folder FLOES_LIBRARIES)
  configure_file(${CPACK_FLOES_PACKAGING}/bundled-floes ${folder}/floes @ONLY FILE_PERMISSIONS OWNER_READ OWNER_WRITE
                 OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endfunction()

file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${root}/bin/floes RESOLVED_DEPENDENCIES_VAR needed)
if(NOT needed)
  message(FATAL_ERROR "${root}/bin/floes needs no library, which cannot be: its tarball would not run elsewhere")
endif()
foreach(library ${needed})
  cmake_path(GET library FILENAME name)  # by which the program asks for it; wheels have no links
  file(COPY_FILE ${library} ${libraries}/${name})
endforeach()
# The program stands beside its loader, as far from share as bin/floes is.
file(RENAME ${root}/bin/floes ${libraries}/floes)
start_script(${root}/bin lib)
# The licence of each: of the package of Debian's that a library is from, which does not know /lib as /usr/lib.
list(TRANSFORM needed REPLACE "^(/usr)?/" "*/")
execute_process(COMMAND dpkg-query --search ${needed} OUTPUT_VARIABLE owners COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+: /" owners "${owners}")
list(TRANSFORM owners REPLACE "(:[a-z0-9]+)?: /$" "")
list(REMOVE_DUPLICATES owners)
foreach(owner ${owners})
  file(INSTALL /usr/share/doc/${owner}/copyright DESTINATION ${root}/share/doc/floes/licences RENAME ${owner}
       FOLLOW_SYMLINK_CHAIN)
endforeach()
set(tarball ${CPACK_PACKAGE_DIRECTORY}/${CPACK_PACKAGE_FILE_NAME}.tar.gz)
cmake_path(GET root PARENT_PATH folder)
cmake_path(GET root FILENAME name)
execute_process(COMMAND ${CMAKE_COMMAND} -E tar czf ${tarball} ${name} WORKING_DIRECTORY ${folder}
                COMMAND_ERROR_IS_FATAL ANY)

# The wheel: all of it in lib/floes of the environment that it is installed into, but for the reader and what starts it.
set(wheel ${folder}/wheel)
set(name floes-${CPACK_PACKAGE_VERSION})
set(data ${wheel}/${name}.data/data/lib/floes)
file(MAKE_DIRECTORY ${wheel}/${name}.data/data/lib)
file(RENAME ${root} ${data})
file(REMOVE_RECURSE ${data}/bin)
start_script(${wheel}/${name}.data/scripts lib/floes/lib)
file(RENAME ${data}/share/floes/python/floes_reader ${wheel}/floes_reader)
file(STRINGS ${data}/share/floes/python/pyproject.toml needs REGEX "^dependencies = ")
string(REGEX MATCHALL "\"[^\"]+\"" needs "${needs}")
list(TRANSFORM needs REPLACE "\"([^\"]+)\"" "Requires-Dist: \\1\n")
list(JOIN needs "" needs)
file(REMOVE ${data}/share/floes/python/pyproject.toml)
file(WRITE ${wheel}/${name}.dist-info/METADATA "Metadata-Version: 2.1
Name: floes
Version: ${CPACK_PACKAGE_VERSION}
Summary: ${CPACK_PACKAGE_DESCRIPTION_SUMMARY}
License: BSD-3-Clause, and those of the libraries in lib/floes/share/doc/floes/licences
Requires-Python: >=3.11
${needs}
${CPACK_DEBIAN_PACKAGE_DESCRIPTION}
")
file(WRITE ${wheel}/${name}.dist-info/WHEEL "Wheel-Version: 1.0
Generator: floes
Root-Is-Purelib: false
Tag: py3-none-linux_${CMAKE_HOST_SYSTEM_PROCESSOR}
")
execute_process(COMMAND /usr/bin/python3 -m wheel pack --dest-dir ${CPACK_PACKAGE_DIRECTORY} ${wheel}
                COMMAND_ERROR_IS_FATAL ANY)
set(CPACK_EXTERNAL_BUILT_PACKAGES ${tarball}
    ${CPACK_PACKAGE_DIRECTORY}/${name}-py3-none-linux_${CMAKE_HOST_SYSTEM_PROCESSOR}.whl)
