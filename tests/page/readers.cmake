# What people open: the report in a browser, the campaign file in their own programs. Debian's own Python, Chromium and
# Octave (packages-test-all.txt); others earlier in the path may not have what it takes.
if(TARGET floes)
  add_test(NAME page.in_browser
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/page/page_in_browser.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml)
  add_test(NAME page.match_in_browser
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/page/match_in_browser.py $<TARGET_FILE:floes>)
  add_test(NAME page.reading_the_file
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/page/reading_the_file.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml ${PROJECT_SOURCE_DIR}/docs/reading_the_file.md)
  set_tests_properties(page.in_browser page.match_in_browser page.reading_the_file
                       PROPERTIES LABELS all TIMEOUT 300)
endif()
