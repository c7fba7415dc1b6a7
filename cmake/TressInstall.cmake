# Installs core, accel and gather as a CMake package, and the command.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

install(TARGETS tress_core tress_accel tress_gather EXPORT tress)
foreach(module core accel gather)
  install(DIRECTORY src/${module} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tress
    FILES_MATCHING PATTERN "*.h" PATTERN "*-inl.h" EXCLUDE)
endforeach()
if(TRESS_TOOLS)
  install(TARGETS tress_command)
endif()

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/tress)
install(EXPORT tress NAMESPACE tress:: DESTINATION ${package} FILE tressTargets.cmake)
configure_package_config_file(cmake/tressConfig.cmake.in tressConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(tressConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/tressConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/tressConfigVersion.cmake
  DESTINATION ${package})
