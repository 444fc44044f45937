# Read by CPack when the files are in place: makes a tarball that brings all libraries along, the C library and its loader
# too, so that it runs on any Linux of its processor, whatever the machine has.
set(root ${CPACK_TEMPORARY_DIRECTORY})
set(libraries ${root}/lib)
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${root}/bin/floes RESOLVED_DEPENDENCIES_VAR needed)
if(NOT needed)
  message(FATAL_ERROR "${root}/bin/floes needs no library, which cannot be: its tarball would not run elsewhere")
endif()
foreach(library ${needed})
  file(INSTALL ${library} DESTINATION ${libraries} FOLLOW_SYMLINK_CHAIN USE_SOURCE_PERMISSIONS)
endforeach()
# The program stands beside its loader, as far from share as bin/floes is.
file(RENAME ${root}/bin/floes ${libraries}/floes)
file(INSTALL ${CPACK_FLOES_PACKAGING}/bundled-floes DESTINATION ${root}/bin RENAME floes
     PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
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
set(CPACK_EXTERNAL_BUILT_PACKAGES ${tarball})
