# What others see of a campaign file: Python readers, h5dump and the page that describes it.
floes_test_program(synthetic_file SOURCES campaign_file/synthetic_file/main.cpp LIBRARIES floes_campaign_file)

# Debian's own Python has the readers (packages-test-all.txt); another one earlier in the path may not.
add_test(NAME campaign_file.readers
         COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/campaign_file/readers_test.py $<TARGET_FILE:synthetic_file>
                 ${PROJECT_SOURCE_DIR}/docs/campaign_file.md)
set_tests_properties(campaign_file.readers PROPERTIES LABELS all TIMEOUT 300)
