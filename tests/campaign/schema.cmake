# The schema of configurations by a public validator (packages-test-all.txt), of Debian's own Python.
if(TARGET floes)
  add_test(NAME campaign.schema
           COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_SOURCE_DIR}/campaign/schema_test.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR})
  set_tests_properties(campaign.schema PROPERTIES LABELS all TIMEOUT 120)
endif()
