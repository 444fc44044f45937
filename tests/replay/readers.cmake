# What others see of a recording: Debian's own Python readers (packages-test-all.txt), and the page that describes it.
if(TARGET floes)
  add_test(NAME replay.readers
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/replay/record_test.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml ${PROJECT_SOURCE_DIR}/docs/replay.md)
  set_tests_properties(replay.readers PROPERTIES LABELS all TIMEOUT 300)
endif()
