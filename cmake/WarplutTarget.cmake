# What every target of this project and all that links one share: language level, sanitizers.
add_library(warplut_options INTERFACE)
target_compile_features(warplut_options INTERFACE cxx_std_20)
if(WARPLUT_SANITIZE)
  target_compile_options(warplut_options INTERFACE -fsanitize=${WARPLUT_SANITIZE}
                         -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(warplut_options INTERFACE -fsanitize=${WARPLUT_SANITIZE})
  # Kernels for fewer instruction sets: they take most of the time to compile.
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_compile_definitions(warplut_options INTERFACE "HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_SSE4)")
  endif()
endif()

# warplut_headers(TARGET FOLDER...): TARGET and its users may include the headers of these folders,
# as "FOLDER/name.h". Every library has an include directory of its own, made of links, so that an
# include against the direction of the libraries (docs/ARCHITECTURE.md) does not build. The runtime
# alone needs no guard: its include directory is the root.
function(warplut_headers target)
  get_target_property(type ${target} TYPE)
  set(scope PUBLIC)
  if(type STREQUAL INTERFACE_LIBRARY)
    set(scope INTERFACE)
  endif()
  if(WARPLUT_RUNTIME_ONLY)
    target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
    return()
  endif()
  set(root ${PROJECT_BINARY_DIR}/include/${target})
  file(REMOVE_RECURSE ${root})
  foreach(folder ${ARGN})
    # Highway includes the sources of kernels once for each instruction set.
    file(GLOB files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.h ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
    file(MAKE_DIRECTORY ${root}/${folder})
    foreach(file ${files})
      get_filename_component(name ${file} NAME)
      file(CREATE_LINK ${file} ${root}/${folder}/${name} COPY_ON_ERROR SYMBOLIC)
    endforeach()
  endforeach()
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${root}>)
endfunction()

# What the compiler tells about this project's sources, and about no others.
add_library(warplut_warnings INTERFACE)
target_compile_options(warplut_warnings INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wpedantic)
# In a unity build sources are included, and g++ takes their anonymous namespaces for a header's.
target_compile_options(
  warplut_warnings
  INTERFACE $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>)
if(WARPLUT_WARNINGS_AS_ERRORS)
  target_compile_options(warplut_warnings INTERFACE -Werror)
endif()

# Promises about NaN and equal bits need a compiler that keeps to IEEE 754, whatever the project
# around says.
add_library(warplut_strict_math INTERFACE)
if(NOT MSVC)
  target_compile_options(warplut_strict_math INTERFACE
                         -fno-fast-math -fno-finite-math-only -fno-unsafe-math-optimizations)
endif()

# Sources that Highway includes again for each instruction set are compiled alone in a unity build.
function(warplut_kernels_alone)
  list(FILTER ARGN INCLUDE REGEX "\\.cpp$")
  foreach(source ${ARGN})
    cmake_path(ABSOLUTE_PATH source)
    file(STRINGS ${source} again REGEX "hwy/foreach_target.h" LIMIT_COUNT 1)
    if(again)
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()

# warplut_library(NAME SOURCES...): a static library with the shared options.
function(warplut_library name)
  add_library(${name} STATIC ${ARGN})
  target_link_libraries(${name} PUBLIC warplut_options PRIVATE $<BUILD_INTERFACE:warplut_warnings>
                                $<BUILD_INTERFACE:warplut_strict_math>)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  warplut_kernels_alone(${ARGN})
endfunction()

# warplut_executable(NAME SOURCES...): a program with the shared options.
function(warplut_executable name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE warplut_options warplut_warnings warplut_strict_math)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
  warplut_kernels_alone(${ARGN})
endfunction()
