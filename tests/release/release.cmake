# What is released: licences, version, recipes, the installed tree and the packages. Included by tests/CMakeLists.txt.

# floes_release_test(NAME LABELS labels… TIMEOUT seconds COMMAND …)
function(floes_release_test name)
  cmake_parse_arguments(TEST "" "TIMEOUT" "LABELS;COMMAND" ${ARGN})
  add_test(NAME release.${name} COMMAND ${TEST_COMMAND})
  set_tests_properties(release.${name} PROPERTIES LABELS "${TEST_LABELS}" TIMEOUT ${TEST_TIMEOUT})
endfunction()

if(TARGET floes)
  set(release_tests ${CMAKE_CURRENT_SOURCE_DIR}/release)
  foreach(script third_party versions)
    floes_release_test(${script} LABELS default TIMEOUT 120
      COMMAND /usr/bin/python3 ${release_tests}/${script}.py ${PROJECT_SOURCE_DIR} $<TARGET_FILE:floes>)
  endforeach()
endif()
