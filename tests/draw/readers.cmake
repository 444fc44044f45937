# The page of a replay in a browser, as page/readers.cmake does it for the report.
if(TARGET floes)
  add_test(NAME draw.in_browser
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/draw/replay_in_browser.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml)
  set_tests_properties(draw.in_browser PROPERTIES LABELS all TIMEOUT 300 PROCESSORS 2)
endif()
