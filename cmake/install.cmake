# Install rules. Component `development`: the headers and library of algebra/ with a package for find_package(tact);
# component `programs`: what people run.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/tact)

install(TARGETS tact_options tact_algebra EXPORT tactTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/algebra DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tact
  COMPONENT development FILES_MATCHING PATTERN "*.h")
install(EXPORT tactTargets NAMESPACE tact:: DESTINATION ${package_dir} COMPONENT development)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/tactConfig.cmake.in
  ${PROJECT_BINARY_DIR}/tactConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tactConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/tactConfig.cmake ${PROJECT_BINARY_DIR}/tactConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindGMP.cmake ${CMAKE_CURRENT_LIST_DIR}/FindSlipLu.cmake
  DESTINATION ${package_dir} COMPONENT development)

foreach(program tact_cli tact-check)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
  endif()
endforeach()
