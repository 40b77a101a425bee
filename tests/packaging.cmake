# What is installed, the two files, and the program of the README, as a stranger meets them.
sheen_script(consumers cross COMMAND tests/packaging/consumers ${PROJECT_BINARY_DIR})
sheen_script(readme_program format COMMAND tests/packaging/readme_program)
