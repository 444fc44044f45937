# cmake -D SOURCE=tree -D OUTPUT=header -P GitRevision.cmake: the tree's revision as a header; "unknown" outside git.
cmake_minimum_required(VERSION 3.22)
set(revision unknown)
find_program(git git)
if(git)
  # Without optional locks: a build must not get into the way of a git command at work.
  execute_process(COMMAND ${CMAKE_COMMAND} -E env GIT_OPTIONAL_LOCKS=0
                          ${git} -C ${SOURCE} describe --always --dirty --abbrev=40 --exclude=*
                  OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
  if(status EQUAL 0)
    set(revision ${found})
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once\n#define FLOES_GIT_REVISION \"@revision@\"\n" @ONLY)
