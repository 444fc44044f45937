# The scripts of slurm/ and of floes array on the real batch systems that each test starts on this machine. Included by
# tests/CMakeLists.txt. Most of their time is waiting, so they begin first (COST), one
# after the other (RESOURCE_LOCK), and share the cores with other tests.
if(TARGET floes)
  foreach(script slurm/campaign slurm/walltime slurm/lost_node slurm/array gridengine/array)
    string(REPLACE / . name ${script})
    add_test(NAME ${name}
             COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/${script}.sh $<TARGET_FILE:floes> ${PROJECT_SOURCE_DIR})
    set_tests_properties(${name} PROPERTIES LABELS "all;slurm" TIMEOUT 900 COST 100 RESOURCE_LOCK waiting)
  endforeach()
  add_test(NAME slurm.array_scripts
           COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/slurm/array_scripts.sh $<TARGET_FILE:floes>)
  set_tests_properties(slurm.array_scripts PROPERTIES LABELS "all;slurm" TIMEOUT 300)
  add_test(NAME slurm.shellcheck COMMAND shellcheck -x -P ${PROJECT_SOURCE_DIR}/slurm job.sh campaign.sbatch smoke.sbatch
           WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/slurm)
  set_tests_properties(slurm.shellcheck PROPERTIES LABELS "all;slurm" TIMEOUT 60)
endif()
