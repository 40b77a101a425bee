# The pages of host-sim/pages.
sheen_script(docs docs COMMAND tests/docs ${PROJECT_BINARY_DIR})
