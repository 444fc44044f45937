# The pages with scripts in a browser, as page/readers.cmake does it for the report.
if(TARGET floes)
  add_test(NAME draw.in_browser
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/draw/replay_in_browser.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml)
  add_test(NAME draw.explore_in_browser
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/draw/explore_in_browser.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml $<TARGET_FILE:synthetic_file>)
  set_tests_properties(draw.in_browser draw.explore_in_browser PROPERTIES LABELS all TIMEOUT 300 COST 60)
endif()
