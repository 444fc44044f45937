# No load knows how floes are cut into elements: an hour and a half on two cores.
if(TARGET floes AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(validation ${PROJECT_SOURCE_DIR}/configs/validation)
  add_test(NAME ice.grain COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/ice/grain_test.py $<TARGET_FILE:floes>
                                  ${validation}/grain_cone.toml ${validation}/grain_wall.toml)
  set_tests_properties(ice.grain PROPERTIES LABELS slow TIMEOUT 7200 PROCESSORS 2)
endif()
