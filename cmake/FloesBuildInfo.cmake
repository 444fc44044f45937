# floes_build_info(TARGET): gives the module store/build_facts.hpp (what was configured) and store/git_revision.hpp
# (looked up at every build, written only when it changed, so that nothing is compiled for nothing).
function(floes_build_info target)
  if(NOT TARGET ${target})
    return()
  endif()
  set(folder ${PROJECT_BINARY_DIR}/generated)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} -ffp-contract=off" FLOES_BUILD_FLAGS)
  configure_file(${PROJECT_SOURCE_DIR}/ensemble/store/build_facts.hpp.in ${folder}/store/build_facts.hpp @ONLY)
  add_custom_target(floes_git_revision
    COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D OUTPUT=${folder}/store/git_revision.hpp
            -P ${PROJECT_SOURCE_DIR}/cmake/GitRevision.cmake
    BYPRODUCTS ${folder}/store/git_revision.hpp VERBATIM)
  add_dependencies(${target} floes_git_revision)
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
