# The command installed, with its page of the manual.
include(GNUInstallDirs)
add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/sheen.1
  COMMAND sheen man > ${CMAKE_CURRENT_BINARY_DIR}/sheen.1 DEPENDS sheen VERBATIM)
add_custom_target(sheen_man ALL DEPENDS ${CMAKE_CURRENT_BINARY_DIR}/sheen.1)
install(TARGETS sheen RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/sheen.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
