# Files of floes export, read back as the programs would that they are for. Debian's own Python has h5py
# (packages-test-all.txt).
if(TARGET floes)
  add_test(NAME load_files.read_back
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/load_files/read_back.py $<TARGET_FILE:floes>
                   $<TARGET_FILE:synthetic_file>)
  set_tests_properties(load_files.read_back PROPERTIES LABELS all TIMEOUT 300)
endif()
