# An overlay port: the sources are beside it. vcpkg install axial --overlay-ports=ports
vcpkg_cmake_configure(SOURCE_PATH "${CURRENT_PORT_DIR}/source" OPTIONS -DAXIAL_OWN_BUILD=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH share/cmake/axial)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug" "${CURRENT_PACKAGES_DIR}/lib")
vcpkg_install_copyright(FILE_LIST "${CURRENT_PORT_DIR}/source/@LICENCE_FILE@")
