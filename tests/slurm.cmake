# The scripts of slurm/ on a real Slurm cluster that each test starts on this machine: tests/slurm/NAME.sh. Included by
# tests/CMakeLists.txt. Most of their time is waiting, so they begin first (COST) and share the cores with other tests.
if(TARGET floes)
  foreach(script campaign walltime lost_node array)
    add_test(NAME slurm.${script}
             COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/slurm/${script}.sh $<TARGET_FILE:floes> ${PROJECT_SOURCE_DIR})
    set_tests_properties(slurm.${script} PROPERTIES LABELS "all;slurm" TIMEOUT 300 COST 100)
  endforeach()
  add_test(NAME slurm.shellcheck COMMAND shellcheck -x -P ${PROJECT_SOURCE_DIR}/slurm job.sh campaign.sbatch
                   smoke.sbatch array.sbatch merge.sbatch
           WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/slurm)
  set_tests_properties(slurm.shellcheck PROPERTIES LABELS "all;slurm" TIMEOUT 60)
endif()
