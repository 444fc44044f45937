# The pages that people read first: every command of the tutorial runs and prints what the page shows, and links lead
# somewhere.
# Debian's own Python has what the blocks need (packages-test-all.txt).
add_test(NAME docs.pages COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/docs/pages_test.py ${PROJECT_SOURCE_DIR})
set_tests_properties(docs.pages PROPERTIES LABELS default TIMEOUT 60)
# The list of the site has every page; the site is built of them and opened in Chromium.
add_test(NAME docs.site_pages COMMAND /usr/bin/python3 -B ${PROJECT_SOURCE_DIR}/docs/site/pages.py ${PROJECT_SOURCE_DIR})
set_tests_properties(docs.site_pages PROPERTIES LABELS default TIMEOUT 60)
add_test(NAME docs.site COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/docs/site_test.py ${PROJECT_SOURCE_DIR})
set_tests_properties(docs.site PROPERTIES LABELS slow TIMEOUT 600 PROCESSORS 2)
# What the headers of src/ declare, as pages: a comment that Doxygen cannot read is an error.
add_test(NAME docs.api COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/docs/api_test.py ${PROJECT_SOURCE_DIR})
set_tests_properties(docs.api PROPERTIES LABELS all TIMEOUT 60)
# A minute on one core; with sanitizers a multiple of that, for what other tests run as well.
if(TARGET floes AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  add_test(NAME docs.tutorial
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/docs/tutorial_test.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/docs/tutorial.md)
  add_test(NAME docs.year_tutorial
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/docs/tutorial_test.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/docs/year.md)
  add_test(NAME docs.moored_hull
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/docs/tutorial_test.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/docs/moorings.md)
  add_test(NAME docs.coupling
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/docs/tutorial_test.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/docs/coupling.md)
  foreach(name design_load optimum served)
    add_test(NAME docs.notebook.${name}
             COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/docs/notebook_test.py $<TARGET_FILE:floes>
                     ${PROJECT_SOURCE_DIR} ${name})
  endforeach()
  set_tests_properties(docs.tutorial docs.coupling PROPERTIES LABELS all TIMEOUT 900 PROCESSORS 2 COST 200)
  # Some minutes: campaigns at full scale, of a year and of notebooks.
  set_tests_properties(docs.moored_hull docs.year_tutorial docs.notebook.design_load docs.notebook.optimum
                       docs.notebook.served PROPERTIES LABELS slow TIMEOUT 1800 PROCESSORS 2)
endif()
