# Faults from a seed, on a simulated machine: faults/history.hpp.
floes_test_program(seeds WITH tests SOURCES faults/seeds.cpp faults/history.cpp LIBRARIES floes_run)
add_test(NAME faults.seeds COMMAND seeds 10000)
add_test(NAME faults.mutants COMMAND seeds --mutants 10000)
set_tests_properties(faults.seeds faults.mutants PROPERTIES LABELS default TIMEOUT 300 COST 60)
add_test(NAME faults.million_seeds COMMAND seeds 1000000)
set_tests_properties(faults.million_seeds PROPERTIES LABELS "slow;seeds" TIMEOUT 36000)

# Which process breaks, when and how: tests/faults/matrix.py.
floes_test_program(faulty WITH all_tests SOURCES faults/main.cpp LIBRARIES floes_run)
foreach(what members processes writers)
  add_test(NAME faults.${what} COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/faults/matrix.py $<TARGET_FILE:faulty>
                                       ${MPIEXEC_EXECUTABLE} ${what})
  set_tests_properties(faults.${what} PROPERTIES LABELS "all;mpi" TIMEOUT 300 COST 90 RESOURCE_LOCK waiting)
endforeach()
add_test(NAME faults.kills COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/faults/matrix.py $<TARGET_FILE:faulty>
                                   ${MPIEXEC_EXECUTABLE} kills 240)
set_tests_properties(faults.kills PROPERTIES LABELS "slow;mpi" TIMEOUT 1800 PROCESSORS 2)
add_test(NAME faults.soak COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/faults/soak.py $<TARGET_FILE:faulty>
                                  ${MPIEXEC_EXECUTABLE} 1000)
set_tests_properties(faults.soak PROPERTIES LABELS "slow;mpi;soak" TIMEOUT 6000 PROCESSORS 2)
add_test(NAME faults.week COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/faults/week.py $<TARGET_FILE:faulty>
                                  ${MPIEXEC_EXECUTABLE} $<TARGET_FILE:floes> 100002 8)
set_tests_properties(faults.week PROPERTIES LABELS "slow;mpi;soak" TIMEOUT 6000 PROCESSORS 2)
add_test(NAME faults.week_of_simulations COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/faults/week.py
                                                 $<TARGET_FILE:faulty> ${MPIEXEC_EXECUTABLE} $<TARGET_FILE:floes>
                                                 2001 8 60 ${PROJECT_SOURCE_DIR}/configs/smoke.toml)
set_tests_properties(faults.week_of_simulations PROPERTIES LABELS "slow;mpi;soak" TIMEOUT 6000 PROCESSORS 2)
