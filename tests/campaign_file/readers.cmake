# What others see of a campaign file: Python readers, h5dump and the page that describes it.
add_executable(synthetic_file ${CMAKE_CURRENT_SOURCE_DIR}/campaign_file/synthetic_file/main.cpp)
target_include_directories(synthetic_file PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(synthetic_file PRIVATE floes_campaign_file)
floes_compile_options(synthetic_file)

# Debian's own Python has the readers (packages-test.txt); another one earlier in the path may not.
add_test(NAME campaign_file.readers
         COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/campaign_file/readers_test.py $<TARGET_FILE:synthetic_file>
                 ${PROJECT_SOURCE_DIR}/docs/campaign_file.md)
set_tests_properties(campaign_file.readers PROPERTIES LABELS default TIMEOUT 300)
