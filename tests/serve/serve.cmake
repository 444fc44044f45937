# floes serve, asked as samplers ask it.
if(TARGET floes)
  add_test(NAME serve.protocol
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/serve/serve_test.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/docs/serve.md)
  set_tests_properties(serve.protocol PROPERTIES LABELS default TIMEOUT 300)
endif()
