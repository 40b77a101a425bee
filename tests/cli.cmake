# Mesh files, pictures, and the command sheen.
sheen_test(test_import unit SOURCES test_import.c test_import_files.c LIBRARIES sheen::host m)
sheen_test(test_import_reference unit SOURCES test_import_reference.c LIBRARIES sheen::host reference m)
sheen_test(test_png unit SOURCES test_png.c LIBRARIES sheen::host)
