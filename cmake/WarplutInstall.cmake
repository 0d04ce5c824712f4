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
  if(NOT CMAKE_CROSSCOMPILING)
    # The program writes its own manual and completions.
    set(manual ${PROJECT_BINARY_DIR}/manual)
    set(completions ${PROJECT_BINARY_DIR}/completions)
    add_custom_command(
      OUTPUT ${manual}/warplut.1 ${completions}/warplut ${completions}/_warplut ${completions}/warplut.fish
      COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${completions}
      COMMAND $<TARGET_FILE:warplut> man ${manual} > ${completions}/manual.txt
      COMMAND $<TARGET_FILE:warplut> completion bash > ${completions}/warplut
      COMMAND $<TARGET_FILE:warplut> completion zsh > ${completions}/_warplut
      COMMAND $<TARGET_FILE:warplut> completion fish > ${completions}/warplut.fish
      DEPENDS warplut
      COMMENT "Writing the manual and the completions")
    add_custom_target(warplut_manual_pages ALL DEPENDS ${manual}/warplut.1)
    install(DIRECTORY ${manual}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
    install(FILES ${completions}/warplut COMPONENT program
            DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
    install(FILES ${completions}/_warplut COMPONENT program
            DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
    install(FILES ${completions}/warplut.fish COMPONENT program
            DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
  endif()
endif()
