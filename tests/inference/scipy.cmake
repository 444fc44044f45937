# Statistics of a real campaign file beside scipy's, by a script that knows nothing of how floes computes. Debian's own
# Python has scipy and h5py (packages-test-all.txt); another one earlier in the path may not.
if(TARGET floes)
  add_test(NAME inference.against_scipy
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/inference/summarize_against_scipy.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml)
  add_test(NAME inference.against_numpy
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/inference/sensitivity_against_numpy.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml)
  add_test(NAME inference.design_against_scipy
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/inference/design_against_scipy.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml)
  set_tests_properties(inference.against_scipy inference.design_against_scipy inference.against_numpy
                       PROPERTIES LABELS all TIMEOUT 300 COST 60)
endif()
