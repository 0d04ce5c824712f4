# What is installed: what a renderer takes, as the package "warplut" of CMake, and the program.
include(CMakePackageConfigHelpers)

set(headers ${CMAKE_INSTALL_INCLUDEDIR}/warplut)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/warplut)

# warplut::runtime; headers are included as "runtime/..." and "luts/...".
set_target_properties(warplut_runtime PROPERTIES EXPORT_NAME runtime)
set_target_properties(warplut_contract PROPERTIES EXPORT_NAME contract)
set_target_properties(warplut_options PROPERTIES EXPORT_NAME options)
install(TARGETS warplut_runtime warplut_contract warplut_options
        EXPORT warplutTargets COMPONENT runtime
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${headers})
# The headers at the top of runtime/ are what a renderer includes; of luts/ it takes the contract.
file(GLOB public_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/runtime/*.h)
install(FILES ${public_headers} DESTINATION ${headers}/runtime COMPONENT runtime)
list(TRANSFORM WARPLUT_CONTRACT_HEADERS PREPEND ${PROJECT_SOURCE_DIR}/luts/ OUTPUT_VARIABLE contract_headers)
install(FILES ${contract_headers} DESTINATION ${headers}/luts COMPONENT runtime)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/luts/baked DESTINATION ${headers}/luts COMPONENT runtime
        FILES_MATCHING PATTERN "*.h")
if(WARPLUT_PIPELINE)
  install(FILES ${WARPLUT_PIPELINE} DESTINATION ${headers} RENAME PIPELINE.h COMPONENT runtime)
endif()
install(EXPORT warplutTargets NAMESPACE warplut:: DESTINATION ${package} COMPONENT runtime)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/warplutConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/warplutConfig.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/warplutConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/warplutConfig.cmake ${PROJECT_BINARY_DIR}/warplutConfigVersion.cmake
        DESTINATION ${package} COMPONENT runtime)

if(TARGET warplut)
  install(TARGETS warplut RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()
