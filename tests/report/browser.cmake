# The report as a browser shows it. Debian's own Python and Chromium (packages-test.txt).
if(TARGET floes)
  add_test(NAME report.page_in_browser
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/report/page_in_browser.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml)
  set_tests_properties(report.page_in_browser PROPERTIES LABELS default TIMEOUT 300 PROCESSORS 2)
endif()
