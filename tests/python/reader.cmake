# python/floes_reader, installed by pip without a network, beside what floes says of the same files; and docs/reading_the_file.md.
# Debian's own Python has what it needs (packages-test-all.txt); another one earlier in the path may not.
if(TARGET floes)
  add_test(NAME python.reader
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/python/reader_test.py $<TARGET_FILE:floes>
                   $<TARGET_FILE:synthetic_file> ${PROJECT_SOURCE_DIR})
  add_test(NAME python.notebook
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/python/notebook.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR})
  set_tests_properties(python.notebook PROPERTIES LABELS all TIMEOUT 300)
  add_test(NAME python.types
           COMMAND /usr/bin/python3 -m mypy --cache-dir=/dev/null --ignore-missing-imports --check-untyped-defs
                   --disallow-untyped-defs ${PROJECT_SOURCE_DIR}/python/floes_reader)
  set_tests_properties(python.types PROPERTIES LABELS all TIMEOUT 120)
  add_test(NAME tables.workbook
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/python/workbook.py $<TARGET_FILE:floes>
                   $<TARGET_FILE:synthetic_file>)
  set_tests_properties(tables.workbook PROPERTIES LABELS all TIMEOUT 300 COST 60)
  set_tests_properties(python.reader PROPERTIES LABELS all TIMEOUT 900 PROCESSORS 2 COST 95)
endif()
