# All of these were added after CMake 3.16: a command, variables, a keyword, a generator expression, a module, a policy.
cmake_path(GET seed STEM name)
if(PROJECT_IS_TOP_LEVEL)
endif()
file(REAL_PATH from to)
set(CMAKE_C_LINKER_LAUNCHER time)
target_link_options(seed PRIVATE $<PATH:GET_STEM,name>)
include(CheckLinkerFlag)
cmake_policy(SET CMP0115 NEW)
