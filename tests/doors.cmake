# The examples, and sheen on other projects' displays (stand-ins), compiled and run.
sheen_script(doors doors COMMAND tests/doors ${PROJECT_BINARY_DIR})
