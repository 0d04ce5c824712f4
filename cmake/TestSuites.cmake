# warplut_add_suites(TARGET [VARIABLE=VALUE]): one test of ctest for each suite of a GoogleTest program, where
# gtest_discover_tests makes one for each test. A program of the offline libraries loads some 260
# shared ones: half a second, more than most of its tests take. tools/junit_summary.awk counts the
# tests in what the suites print. VARIABLE is set in the environment.
function(warplut_add_suites target)
  set(list ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
  file(GENERATE OUTPUT ${list} CONTENT
"set(program \"$<TARGET_FILE:${target}>\")
set(name ${target})
set(environment ${ARGN})
include(\"${PROJECT_SOURCE_DIR}/cmake/ListSuites.cmake\")
")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${list})
  warplut_precompile_gtest(${target})
endfunction()

# GoogleTest and the headers of the standard library that most tests include are half of the time
# that a test takes to compile. The preset dev compiles without, and so finds includes that lack.
function(warplut_precompile_gtest target)
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources count)
  if(count LESS 4)
    return()
  endif()
  get_target_property(libraries ${target} LINK_LIBRARIES)
  set(headers <gtest/gtest.h> <algorithm> <cmath> <filesystem> <string> <vector>)
  if("GTest::gmock" IN_LIST libraries)
    list(PREPEND headers <gmock/gmock.h>)
  endif()
  target_precompile_headers(${target} PRIVATE ${headers})
  # g++ 12 warns inside of std::string where its header is precompiled.
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow)
  endif()
endfunction()
