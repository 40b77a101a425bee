# The Debian package, by `cpack` in a build folder: what `cmake --install` installs, and what Debian asks for besides.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME sheen)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "the sheen authors <sheen@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "integer-only shaded 3D for small displays")
set(CPACK_PACKAGE_DESCRIPTION "A library that draws shaded meshes with integers only, in bands, and sends them
to the small displays of microcontrollers; sheen, which shows on simulated
panels what a board would show; and sheen-panel, which drives a panel that is
wired to a Linux board.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
  WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/documents.cmake)
set(CPACK_SHEEN_SOURCE ${PROJECT_SOURCE_DIR})
include(CPack)
