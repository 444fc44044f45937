# Tests that run under mpirun. Included by tests/CMakeLists.txt.

# Open MPI wants to be told that ranks may outnumber cores, and that root is meant; others do not know these options.
execute_process(COMMAND ${MPIEXEC_EXECUTABLE} --version OUTPUT_VARIABLE mpiexec_version ERROR_QUIET)
set(floes_mpi_options)
if(mpiexec_version MATCHES "Open MPI|OpenRTE")
  set(floes_mpi_options --allow-run-as-root --oversubscribe --bind-to none)
endif()

# floes_mpi_test(NAME RANKS n… COMMAND program arguments…)
#   CTest tests NAME.1_rank, NAME.2_ranks, … : the command on that many ranks, whatever the machine and the user.
function(floes_mpi_test name)
  cmake_parse_arguments(TEST "" "TIMEOUT" "RANKS;COMMAND" ${ARGN})
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 120)
  endif()
  foreach(ranks ${TEST_RANKS})
    set(full_name ${name}.${ranks}_ranks)
    add_test(NAME ${full_name}
             COMMAND ${MPIEXEC_EXECUTABLE} ${floes_mpi_options} -n ${ranks} ${TEST_COMMAND})
    set_tests_properties(${full_name} PROPERTIES LABELS "default;mpi" TIMEOUT ${TEST_TIMEOUT} PROCESSORS 2
                         ENVIRONMENT "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1")
  endforeach()
endfunction()

floes_test_program(test_mpi_link SOURCES run/mpi/mpi_link_test.cpp LIBRARIES floes_run GTest::gtest)
floes_mpi_test(run.mpi_link RANKS 1 2 3 COMMAND test_mpi_link)

# Whole campaigns by the program itself: tests/campaign_run/NAME.sh.
if(TARGET floes)
  foreach(script same_everywhere kill_and_resume stop_and_resume long_member refusals calibrated parts storage_faults starter)
    add_test(NAME campaign_run.${script}
             COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/campaign_run/${script}.sh $<TARGET_FILE:floes> ${MPIEXEC_EXECUTABLE})
    set_tests_properties(campaign_run.${script} PROPERTIES LABELS "default;mpi" TIMEOUT 900 PROCESSORS 2 COST 80)
  endforeach()
endif()
