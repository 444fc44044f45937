# What is released: licences, version, recipes, the installed tree and the packages. Included by tests/CMakeLists.txt.

# floes_release_test(NAME LABELS labels… TIMEOUT seconds COMMAND …)
function(floes_release_test name)
  cmake_parse_arguments(TEST "" "TIMEOUT" "LABELS;COMMAND" ${ARGN})
  add_test(NAME release.${name} COMMAND ${TEST_COMMAND})
  set_tests_properties(release.${name} PROPERTIES LABELS "${TEST_LABELS}" TIMEOUT ${TEST_TIMEOUT})
endfunction()

if(TARGET floes)
  set(release_tests ${CMAKE_CURRENT_SOURCE_DIR}/release)
  foreach(script versions recipes)
    floes_release_test(${script} LABELS all TIMEOUT 120
      COMMAND /usr/bin/python3 ${release_tests}/${script}.py ${PROJECT_SOURCE_DIR} $<TARGET_FILE:floes>)
  endforeach()
  if(TARGET floes_manual)
    floes_release_test(pages LABELS all TIMEOUT 120
      COMMAND /usr/bin/python3 ${release_tests}/pages.py $<TARGET_FILE:floes> ${PROJECT_BINARY_DIR}/manual
              --synthetic=$<TARGET_FILE:synthetic_file>)
    floes_release_test(shells LABELS slow TIMEOUT 300
      COMMAND /usr/bin/python3 ${release_tests}/pages.py $<TARGET_FILE:floes> ${PROJECT_BINARY_DIR}/manual --shells)
    floes_release_test(install LABELS all TIMEOUT 120
      COMMAND bash ${release_tests}/install.sh ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR})
    floes_release_test(wheel LABELS all TIMEOUT 600
      COMMAND bash ${release_tests}/wheel.sh ${PROJECT_BINARY_DIR} $<TARGET_FILE:floes>)
    floes_release_test(scripts LABELS all TIMEOUT 60
      COMMAND shellcheck -x install.sh wheel.sh debian_root.sh old_processor.sh
              ${PROJECT_SOURCE_DIR}/packaging/clusters/pbs/campaign.pbs
              ${PROJECT_SOURCE_DIR}/packaging/clusters/lsf/campaign.lsf)
    set_tests_properties(release.scripts PROPERTIES WORKING_DIRECTORY ${release_tests})
    floes_release_test(debian_root LABELS slow TIMEOUT 1800
      COMMAND bash ${release_tests}/debian_root.sh ${PROJECT_BINARY_DIR} $<TARGET_FILE:floes> ${PROJECT_SOURCE_DIR})
  endif()
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND CMAKE_BUILD_TYPE STREQUAL "Release")
    floes_release_test(old_processor LABELS slow TIMEOUT 300
      COMMAND bash ${release_tests}/old_processor.sh $<TARGET_FILE:floes> ${MPIEXEC_EXECUTABLE})
    # Not in builds with sanitizers, which load libraries of their own.
    floes_release_test(third_party LABELS default TIMEOUT 120
      COMMAND /usr/bin/python3 ${release_tests}/third_party.py ${PROJECT_SOURCE_DIR} $<TARGET_FILE:floes>)
    floes_release_test(kernels LABELS default TIMEOUT 120
      COMMAND /usr/bin/python3 ${release_tests}/kernels.py ${PROJECT_BINARY_DIR} $<TARGET_FILE:floes>)
  endif()
endif()
