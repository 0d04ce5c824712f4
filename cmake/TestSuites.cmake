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
endfunction()
