# cmake --install: the library's headers and the robots', found again by find_package(axial) and pkg-config. No hal, no app.
# Nothing is compiled, so one installation serves every processor.
include(CMakePackageConfigHelpers)
set(package_dir share/cmake/axial)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/firmware/include/axial DESTINATION include
  FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/robots DESTINATION include FILES_MATCHING PATTERN "*.hpp")

install(TARGETS axial EXPORT axial)
install(EXPORT axial NAMESPACE axial:: FILE axialConfig.cmake DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/axialConfigVersion.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/axialConfigVersion.cmake DESTINATION ${package_dir})

configure_file(${PROJECT_SOURCE_DIR}/cmake/axial.pc.in ${PROJECT_BINARY_DIR}/axial.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/axial.pc DESTINATION share/pkgconfig)
