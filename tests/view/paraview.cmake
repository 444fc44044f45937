# Debian's ParaView (packages-slow.txt) opens a replay's series and shows it by its state, on a display that is none.
add_executable(record_as_vtk ${CMAKE_CURRENT_SOURCE_DIR}/view/record_as_vtk/main.cpp)
target_link_libraries(record_as_vtk PRIVATE floes_view)
floes_compile_options(record_as_vtk)

if(TARGET floes)
  add_test(NAME view.in_paraview
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/view/vtk_in_paraview.py $<TARGET_FILE:floes>
                   $<TARGET_FILE:record_as_vtk> ${PROJECT_SOURCE_DIR}/configs/smoke.toml)
  set_tests_properties(view.in_paraview PROPERTIES LABELS slow TIMEOUT 600 PROCESSORS 2)
endif()
