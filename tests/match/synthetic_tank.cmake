# Tank tests that floes makes itself from hidden inputs.
if(TARGET floes)
  add_test(NAME match.synthetic_tank
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/match/synthetic_tank.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml)
  set_tests_properties(match.synthetic_tank PROPERTIES LABELS slow TIMEOUT 900 PROCESSORS 2)

  # Ten tanks each of ten hidden combinations, from four waves: some ten minutes.
  add_test(NAME match.truth_kept
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/match/truth_kept.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml)
  set_tests_properties(match.truth_kept PROPERTIES LABELS slow TIMEOUT 3600 PROCESSORS 2)
endif()
