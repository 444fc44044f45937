# What most files include, read once: a room that uses it compiles in half the time.
file(WRITE ${PROJECT_BINARY_DIR}/generated/precompiled.cpp "")
add_library(floes_precompiled STATIC ${PROJECT_BINARY_DIR}/generated/precompiled.cpp)
target_link_libraries(floes_precompiled PRIVATE Eigen3::Eigen fmt::fmt)
target_precompile_headers(floes_precompiled PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp)

# floes_room(src/NAME ROOMS lower rooms… LIBRARIES public… PRIVATE private…)
#   One static library floes_NAME of every .cpp in the folder, or an interface library for headers alone.
#   Rooms are included as "NAME/file.hpp".
function(floes_room path)
  cmake_parse_arguments(ROOM "" "" "ROOMS;LIBRARIES;PRIVATE" ${ARGN})
  get_filename_component(name ${path} NAME)
  get_filename_component(parent ${path} DIRECTORY)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${path}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  list(TRANSFORM ROOM_ROOMS PREPEND floes_)
  if(sources)
    add_library(floes_${name} STATIC ${sources})
    target_include_directories(floes_${name} PUBLIC ${PROJECT_SOURCE_DIR}/${parent})
    target_link_libraries(floes_${name} PUBLIC ${ROOM_ROOMS} ${ROOM_LIBRARIES} PRIVATE ${ROOM_PRIVATE})
    floes_compile_options(floes_${name})
    target_precompile_headers(floes_${name} REUSE_FROM floes_precompiled)
  else()
    add_library(floes_${name} INTERFACE)
    target_include_directories(floes_${name} INTERFACE ${PROJECT_SOURCE_DIR}/${parent})
    target_link_libraries(floes_${name} INTERFACE ${ROOM_ROOMS} ${ROOM_LIBRARIES})
  endif()
endfunction()

# No FMA contraction: the same bits on every CPU and at every lane width.
function(floes_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow
                         -Wnon-virtual-dtor -Woverloaded-virtual $<$<BOOL:${FLOES_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()
floes_compile_options(floes_precompiled)

# Each kernels_*.cpp of a room for its own instruction set; which one runs is decided at run time.
function(floes_lane_kernels path)
  set(kernels -fno-math-errno -Wno-psabi)
  set(instructions_scalar)
  set(instructions_sse2 -msse2)
  set(instructions_avx2 -mavx2)
  set(instructions_avx512 -mavx512f -mprefer-vector-width=512)
  foreach(set scalar sse2 avx2 avx512)
    set(source ${PROJECT_SOURCE_DIR}/${path}/kernels_${set}.cpp)
    if(set STREQUAL "scalar" OR CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
      set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "${kernels};${instructions_${set}}"
                                  SKIP_PRECOMPILE_HEADERS ON)
    else()
      set_source_files_properties(${source} PROPERTIES HEADER_FILE_ONLY ON)
    endif()
  endforeach()
endfunction()

# floes_tests(NAME ROOMS rooms… [LIBRARIES libs…] [LABELS labels…] [SOURCES files…] [LONG filter])
#   One GoogleTest program test_NAME of tests/NAME/*.cpp, every TEST a CTest test. LONG: those of them that average for
#   ten seconds and more, which are slow.
function(floes_tests name)
  cmake_parse_arguments(TEST "" "TIMEOUT;LONG" "ROOMS;LIBRARIES;LABELS;SOURCES" ${ARGN})
  if(NOT TEST_SOURCES)
    file(GLOB TEST_SOURCES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${name}/*.cpp)
  endif()
  if(NOT TEST_SOURCES)
    return()
  endif()
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 300)
  endif()
  if(NOT TEST_LABELS)
    set(TEST_LABELS default)
  endif()
  list(TRANSFORM TEST_ROOMS PREPEND floes_)
  floes_test_program(test_${name} SOURCES ${TEST_SOURCES}
                     LIBRARIES ${TEST_ROOMS} ${TEST_LIBRARIES} GTest::gtest GTest::gmock GTest::gtest_main)
  target_precompile_headers(test_${name} REUSE_FROM floes_tests_precompiled)
  set(usual "*")
  if(TEST_LONG)
    set(usual "-${TEST_LONG}")
    gtest_discover_tests(test_${name} TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60 TEST_FILTER "${TEST_LONG}"
                         TEST_LIST test_${name}_LONG PROPERTIES LABELS slow TIMEOUT ${TEST_TIMEOUT})
  endif()
  gtest_discover_tests(test_${name} TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60 TEST_FILTER "${usual}"
                       PROPERTIES LABELS "${TEST_LABELS}" TIMEOUT ${TEST_TIMEOUT})
endfunction()

# floes_test_program(TARGET SOURCES files… LIBRARIES libs…): a program that tests need; the target `tests` builds them
# all.
function(floes_test_program target)
  cmake_parse_arguments(PROGRAM "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${target} ${PROGRAM_SOURCES})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${target} PRIVATE FLOES_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${target} PRIVATE ${PROGRAM_LIBRARIES})
  floes_compile_options(${target})
  floes_quick_to_compile(${target})
  add_dependencies(tests ${target})
endfunction()

# What tests do themselves need not be fast. At -O1 g++ 12 warns of what is not so in the standard library.
function(floes_quick_to_compile target)
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    target_compile_options(${target} PRIVATE -O1 -Wno-array-bounds -Wno-mismatched-new-delete
                           -Wno-stringop-overflow)
  endif()
endfunction()
