# The runtime as a library, whole or with what one content needs.
set(WARPLUT_ROOT ${CMAKE_CURRENT_LIST_DIR}/.. CACHE INTERNAL "The root of the sources")

# warplut_runtime_library(NAME [PIPELINE HEADER]): a static library of the runtime. HEADER, a
# PIPELINE.h (runtime/pipeline_configuration.h), says what it contains; without it everything. What
# links it is compiled with the same header. Sections are small, so that a program linked with
# --gc-sections keeps only what it calls.
function(warplut_runtime_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PIPELINE" "")
  find_package(HWY REQUIRED CONFIG NAMES HWY hwy)
  find_package(Threads REQUIRED)
  set(generation
    blend_reference.cpp
    color_repair.cpp
    drawn_anew.cpp
    frame_check.cpp
    frame_coefficients.cpp
    frame_generation.cpp
    hdr_rows.cpp
    row_kernels.cpp
    splat_reference.cpp
    motion/surface_before_reference.cpp
    motion/target_motion.cpp
    motion/target_motion_reference.cpp)
  list(TRANSFORM generation PREPEND ${WARPLUT_ROOT}/runtime/generation/)
  set(sr
    aliasing.cpp
    fast_passes.cpp
    frame_check.cpp
    reference_color.cpp
    reference_geometry.cpp
    super_resolution.cpp)
  list(TRANSFORM sr PREPEND ${WARPLUT_ROOT}/runtime/sr/)
  set(peers
    generation/bidirectional.cpp
    generation/bidirectional_reference.cpp
    generation/mesh_projection.cpp
    generation/mesh_projection_reference.cpp
    generation/mesh_warp.cpp
    generation/mesh_warp_reference.cpp
    rays/depth_pyramid.cpp
    rays/screen_mesh.cpp
    rays/screen_ray.cpp
    sr/fsr2.cpp
    sr/fsr2_reference.cpp
    sr/sgsr2.cpp
    sr/taau.cpp)
  list(TRANSFORM peers PREPEND ${WARPLUT_ROOT}/runtime/peers/)
  set(dense
    compose.cpp
    compose_reference.cpp
    dense_order.cpp
    dense_rendering.cpp)
  list(TRANSFORM dense PREPEND ${WARPLUT_ROOT}/runtime/dense/)
  set(shared
    motion/camera_motion.cpp
    core/executor.cpp
    core/float_environment.cpp
    core/hud.cpp
    core/image_check.cpp
    configuration/method.cpp
    motion/motion_filter.cpp
    motion/motion_tiles.cpp
    motion/point_carrier.cpp
    configuration/parameters.cpp
    configuration/pipeline.cpp
    warp/prefilter.cpp
    warp/prefilter_kernels.cpp
    warp/warp.cpp
    warp/warp_kernels.cpp
    warp/warp_reference.cpp)
  list(TRANSFORM shared PREPEND ${WARPLUT_ROOT}/runtime/)

  warplut_library(${name} ${shared} ${generation} ${sr} ${peers} ${dense})
  target_link_libraries(${name} PUBLIC warplut_contract $<BUILD_INTERFACE:warplut_runtime_headers> Threads::Threads
                        PRIVATE hwy::hwy)
  if(arg_PIPELINE)
    get_filename_component(header ${arg_PIPELINE} ABSOLUTE)
    # The installed library has the header beside its own (cmake/WarplutInstall.cmake).
    target_compile_definitions(${name} PUBLIC
      "WARPLUT_PIPELINE_HEADER=\"$<BUILD_INTERFACE:${header}>$<INSTALL_INTERFACE:PIPELINE.h>\"")
  endif()
  # Other libraries see what the installed headers declare (luts/visibility.h).
  set_target_properties(${name} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  if(NOT MSVC)
    target_compile_options(${name} PRIVATE -ffunction-sections -fdata-sections)
    # The plain and the fast version of a pass give the same bits, and so do compilers: none may fuse
    # multiply and add where the source does not.
    set_source_files_properties(${generation} ${sr} ${peers} ${dense} TARGET_DIRECTORY ${name}
                                PROPERTIES COMPILE_OPTIONS -ffp-contract=off)
  endif()
endfunction()
