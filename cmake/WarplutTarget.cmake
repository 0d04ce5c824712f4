# What every target of this project and all that links one share: language level, sanitizers, include root.
add_library(warplut_options INTERFACE)
target_compile_features(warplut_options INTERFACE cxx_std_20)
target_include_directories(warplut_options INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
if(WARPLUT_SANITIZE)
  target_compile_options(warplut_options INTERFACE -fsanitize=${WARPLUT_SANITIZE}
                         -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(warplut_options INTERFACE -fsanitize=${WARPLUT_SANITIZE})
  # Kernels for fewer instruction sets: they take most of the time to compile.
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_compile_definitions(warplut_options INTERFACE "HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_SSE4)")
  endif()
endif()

# What the compiler tells about this project's sources, and about no others.
add_library(warplut_warnings INTERFACE)
target_compile_options(warplut_warnings INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wpedantic)
if(WARPLUT_WARNINGS_AS_ERRORS)
  target_compile_options(warplut_warnings INTERFACE -Werror)
endif()

# warplut_library(NAME SOURCES...): a static library with the shared options.
function(warplut_library name)
  add_library(${name} STATIC ${ARGN})
  target_link_libraries(${name} PUBLIC warplut_options PRIVATE $<BUILD_INTERFACE:warplut_warnings>)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
endfunction()

# warplut_executable(NAME SOURCES...): a program with the shared options.
function(warplut_executable name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE warplut_options warplut_warnings)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
endfunction()
