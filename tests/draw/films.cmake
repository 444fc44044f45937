# Films that ffmpeg makes (packages-slow.txt).
if(TARGET floes)
  add_test(NAME draw.films
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/draw/films.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml)
  set_tests_properties(draw.films PROPERTIES LABELS slow TIMEOUT 300)
endif()
