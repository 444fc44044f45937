# Arching at a gap has a threshold: some minutes of one core.
if(TARGET floes AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  add_test(NAME simulation.arch COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/simulation/arch_test.py
                                        $<TARGET_FILE:floes> ${PROJECT_SOURCE_DIR}/configs/validation/arch_gap.toml)
  set_tests_properties(simulation.arch PROPERTIES LABELS slow TIMEOUT 1800 PROCESSORS 2)
endif()
