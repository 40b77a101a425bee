# The examples, and sheen on other projects' displays (stand-ins), compiled and run.
sheen_script(doors doors COMMAND tests/doors ${PROJECT_BINARY_DIR})
sheen_script(sketch doors COMMAND tests/boards/sketch $<TARGET_FILE:sheen> $<TARGET_FILE:board_glass>
  ${PROJECT_BINARY_DIR}/sketch)
