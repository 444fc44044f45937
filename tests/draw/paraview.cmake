# Debian's ParaView (packages-slow.txt) opens a replay's series and shows it by its state, on a display that is none.
if(TARGET floes)
  add_test(NAME draw.in_paraview
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/draw/in_paraview.py $<TARGET_FILE:floes>
                   ${PROJECT_SOURCE_DIR}/configs/smoke.toml)
  set_tests_properties(draw.in_paraview PROPERTIES LABELS slow TIMEOUT 600 PROCESSORS 2)
endif()
