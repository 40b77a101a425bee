# What is installed, the two files, and the README's program, used from outside of the repository.
sheen_script(consumers cross COMMAND tests/packaging/consumers ${PROJECT_BINARY_DIR})
sheen_script(cmake_floor format COMMAND tests/packaging/cmake_floor)
sheen_script(seeded_cmake_floor format COMMAND tests/checks/refuses "7 too new in 1 files"
  tests/packaging/cmake_floor tests/checks/seeded/new.cmake)
sheen_script(panel_names packages COMMAND tests/packaging/panel_names $<TARGET_FILE:sheen> $<TARGET_FILE:sheen_hal>)
sheen_script(no_cairo cross COMMAND tests/packaging/no_cairo)
sheen_script(readme_program format COMMAND tests/packaging/readme_program)

# Packages for other build systems and for Debian.
sheen_script(manifests packages COMMAND tests/packaging/manifests)
sheen_script(seeded_manifests packages COMMAND tests/packaging/manifests_seeded)
sheen_script(debian_package packages COMMAND tests/packaging/debian)
sheen_script(two_files_panel packages COMMAND tests/packaging/two_files_panel)
sheen_script(no_room packages COMMAND tests/packaging/no_room)
