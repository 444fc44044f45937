# What most files include, read once: a module that uses it compiles in half the time.
file(WRITE ${PROJECT_BINARY_DIR}/generated/precompiled.cpp "")
add_library(floes_precompiled STATIC ${PROJECT_BINARY_DIR}/generated/precompiled.cpp)
target_link_libraries(floes_precompiled PRIVATE Eigen3::Eigen fmt::fmt)
target_precompile_headers(floes_precompiled PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp)

# All modules' headers, for tests and benchmarks.
add_library(floes_headers INTERFACE)

# floes_module(src/NAME USES modules… INSIDE modules… LIBRARIES public… PRIVATE private…)
#   One static library floes_NAME of every .cpp in the folder. Its headers are included as "NAME/file.hpp", by a folder of
#   links that holds no other module. Ten sources are compiled as one where FLOES_UNITY is on, so two sources of a module
#   do not give one name to two things.
function(floes_module path)
  cmake_parse_arguments(MODULE "" "" "USES;INSIDE;LIBRARIES;PRIVATE" ${ARGN})
  get_filename_component(name ${path} NAME)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${path}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  list(TRANSFORM MODULE_USES PREPEND floes_)
  list(TRANSFORM MODULE_INSIDE PREPEND floes_)
  set(headers ${PROJECT_BINARY_DIR}/include/${name})
  file(MAKE_DIRECTORY ${headers})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${path} ${headers}/${name} SYMBOLIC)
  add_library(floes_${name} STATIC ${sources})
  target_include_directories(floes_${name} PUBLIC ${headers})
  target_include_directories(floes_headers INTERFACE ${headers})
  target_link_libraries(floes_${name} PUBLIC ${MODULE_USES} ${MODULE_LIBRARIES} PRIVATE ${MODULE_INSIDE} ${MODULE_PRIVATE})
  floes_compile_options(floes_${name})
  target_precompile_headers(floes_${name} REUSE_FROM floes_precompiled)
  set_target_properties(floes_${name} PROPERTIES UNITY_BUILD ${FLOES_UNITY} UNITY_BUILD_BATCH_SIZE 10)
  if(name IN_LIST FLOES_COVERAGE)
    target_compile_options(floes_${name} PRIVATE --coverage -Og)
    target_link_options(floes_${name} INTERFACE --coverage)
    set_target_properties(floes_${name} PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)  # they are of another optimisation
  endif()
endfunction()

# No FMA contraction: the same bits on every CPU and at every lane width. Modules are in the shared library of FMUs too,
# which exports no symbol of theirs.
function(floes_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -ffp-contract=off -fPIC -fvisibility=hidden -Wall -Wextra -Wpedantic
                         # A constant of another source is no shadow, which clang does not know.
                         $<$<CXX_COMPILER_ID:GNU>:-Wshadow$<$<BOOL:${FLOES_UNITY}>:=local>>
                         -Wnon-virtual-dtor -Woverloaded-virtual $<$<BOOL:${FLOES_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()
floes_compile_options(floes_precompiled)

# floes_lane_kernels(src/NAME FILE KERNELS): compiles NAME/FILE, all kernels of one lane width, for each instruction set
# into an object that is called KERNELS_SET; which one runs is decided at run time.
function(floes_lane_kernels path file kernels)
  get_filename_component(name ${path} NAME)
  set(sets scalar:1)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND sets sse2:2:-msse2 avx2:4:-mavx2 "avx512:8:-mavx512f -mprefer-vector-width=512")
  endif()
  foreach(entry ${sets})
    string(REPLACE ":" ";" entry "${entry}:")
    list(GET entry 0 set)
    list(GET entry 1 lanes)
    list(GET entry 2 options)
    separate_arguments(options)
    set(source ${PROJECT_BINARY_DIR}/generated/${name}/kernels_${set}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT
         "#define FLOES_LANES ${lanes}\n#define FLOES_KERNELS ${kernels}_${set}\n#include \"${name}/${file}\"\n")
    target_sources(floes_${name} PRIVATE ${source})
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "-fno-math-errno;-Wno-psabi;${options}"
                                SKIP_PRECOMPILE_HEADERS ON)
  endforeach()
endfunction()

# floes_tests(NAME MODULES modules… [LIBRARIES libs…] [LABEL label] [SOURCES files…] [LONG filter] [SLOW filter] [QUICK])
#   One GoogleTest program test_NAME of tests/NAME/*.cpp, every TEST a CTest test with the label default or the one given.
#   LONG: those of them that take ten seconds and more, which have the label all; SLOW: minutes, with the label slow.
#   QUICK: run under the sanitizers as well, whenever all tests run. Twenty sources are compiled as one; each has a namespace of its own for what it needs.
function(floes_tests name)
  cmake_parse_arguments(TEST "QUICK" "TIMEOUT;LONG;SLOW;LABEL" "MODULES;LIBRARIES;SOURCES" ${ARGN})
  if(NOT TEST_SOURCES)
    file(GLOB TEST_SOURCES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${name}/*.cpp)
  endif()
  if(NOT TEST_SOURCES)
    return()
  endif()
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 300)
  endif()
  if(NOT TEST_LABEL)
    set(TEST_LABEL default)
  endif()
  list(TRANSFORM TEST_MODULES PREPEND floes_)
  if(TEST_LABEL STREQUAL "default")
    set(with tests)
  else()
    set(with all_tests)
  endif()
  floes_test_program(test_${name} WITH ${with} SOURCES ${TEST_SOURCES}
                     LIBRARIES ${TEST_MODULES} ${TEST_LIBRARIES} GTest::gtest GTest::gmock GTest::gtest_main)
  target_precompile_headers(test_${name} REUSE_FROM floes_tests_precompiled)
  set_target_properties(test_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 20)
  if(TEST_QUICK)
    add_dependencies(quick_tests test_${name})
    set(TEST_LABEL "${TEST_LABEL}-quick")  # one label, which -L default and -L quick both find
  endif()
  set(LONG_label all)
  set(SLOW_label slow)
  set(usual "")
  foreach(kind LONG SLOW)
    if(TEST_${kind})
      string(APPEND usual ":${TEST_${kind}}")
      gtest_discover_tests(test_${name} TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60 TEST_FILTER "${TEST_${kind}}"
                           TEST_LIST test_${name}_${kind} PROPERTIES LABELS ${${kind}_label} TIMEOUT ${TEST_TIMEOUT})
    endif()
  endforeach()
  string(REGEX REPLACE "^:" "*-" usual "${usual}")
  gtest_discover_tests(test_${name} TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60 TEST_FILTER "${usual}"
                       PROPERTIES LABELS "${TEST_LABEL}" TIMEOUT ${TEST_TIMEOUT})
endfunction()

# floes_test_program(TARGET [WITH tests | all_tests] SOURCES files… LIBRARIES libs…): a program that tests need. The target
# `tests` builds those that tests of the label default need, `all_tests` all.
function(floes_test_program target)
  cmake_parse_arguments(PROGRAM "" "WITH" "SOURCES;LIBRARIES" ${ARGN})
  if(NOT PROGRAM_WITH)
    set(PROGRAM_WITH tests)
  endif()
  add_executable(${target} ${PROGRAM_SOURCES})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${target} PRIVATE FLOES_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${target} PRIVATE floes_headers ${PROGRAM_LIBRARIES})
  floes_compile_options(${target})
  floes_quick_to_compile(${target})
  add_dependencies(${PROGRAM_WITH} ${target})
endfunction()

# What tests do themselves need not be fast, but at -O0 they take longer to run than that saves. At -O1 g++ 12 warns of
# what is not so in the standard library.
function(floes_quick_to_compile target)
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    target_compile_options(${target} PRIVATE -O1 -Wno-array-bounds -Wno-mismatched-new-delete
                           -Wno-stringop-overflow)
  endif()
endfunction()
