# Mesh files, pictures, and the command sheen.
sheen_test(test_import unit SOURCES test_import.c test_import_files.c LIBRARIES sheen::host m)
sheen_test(test_import_reference unit SOURCES test_import_reference.c LIBRARIES sheen::host sheen::core reference m)
sheen_test(test_png unit SOURCES test_png.c LIBRARIES sheen::host)

sheen_script(cli_usage cli COMMAND tests/cli/usage $<TARGET_FILE:sheen>)
sheen_script(cli_render cli COMMAND tests/cli/render $<TARGET_FILE:sheen> tests/data/egg.obj)
sheen_test(test_import_confined unit SOURCES test_import_confined.c test_import_files.c LIBRARIES sheen::host)
sheen_script(cli_bad_input cli COMMAND tests/cli/bad_input $<TARGET_FILE:sheen> TIMEOUT 300)
sheen_test(test_import_hostile unit SOURCES test_import_hostile.c test_import_files.c LIBRARIES sheen::host sheen::core m
  TIMEOUT 300)
