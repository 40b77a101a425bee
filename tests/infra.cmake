# The checks of tests/checks (the core as firmware gets it, the same bits everywhere, the layout of sources), and tests
# of these checks.
sheen_script(core_freestanding freestanding COMMAND tests/checks/freestanding)
sheen_script(linked_sizes freestanding COMMAND tests/checks/linked/sizes)
sheen_script(core_rules freestanding COMMAND tests/checks/core_rules)
sheen_script(core_embedded freestanding COMMAND tests/checks/embedded/build)
sheen_script(layout format COMMAND tests/checks/layout)
sheen_script(names format COMMAND tests/checks/names
  $<TARGET_FILE:sheen_core> $<TARGET_FILE:sheen_hal> $<TARGET_FILE:sheen_sim> $<TARGET_FILE:sheen_host>)
# Draws one in seven scenes.
sheen_script(same_bits cross COMMAND tests/checks/cross)
if(NOT SHEEN_SANITIZED)
  sheen_script(same_bits_whole long COMMAND tests/checks/cross --whole . gcc-O2 gcc-O0 gcc-O3 small-core
    slow-loops clang-O2 tcc sanitizers armhf m0plus m3 riscv64 powerpc lx106 rv32imc)
  sheen_script(thumb_faults long COMMAND tests/checks/thumb_faults)
endif()

# The folders: which may include and call which, and the tables that describe them.
sheen_script(core_floors format COMMAND tests/checks/floors)
sheen_script(one_unit format COMMAND tests/checks/one_unit)
sheen_script(core_house format COMMAND tests/checks/house)
sheen_script(host_house format COMMAND tests/checks/house host-sim/README.md host-sim)
foreach(text "flat.c includes frame/frame.h" "pixel.c calls sheen_seed_frame" "phong.c calls sheen_seed_flat")
  string(MAKE_C_IDENTIFIER ${text} name)
  sheen_script(seeded_floors_${name} format COMMAND tests/checks/refuses ${text}
    tests/checks/floors tests/checks/seeded/floors)
endforeach()
sheen_script(seeded_house format COMMAND tests/checks/refuses "no row for floors/"
  tests/checks/house core/README.md tests/checks/seeded)

# The first line of each seed names the check that must refuse (or accept) it.
file(GLOB seeds CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/checks/seeded/*.c)
foreach(seed IN LISTS seeds)
  get_filename_component(name ${seed} NAME_WE)
  set(part freestanding)
  if(name MATCHES "^layout_")
    set(part format)
  endif()
  sheen_script(seeded_${name} ${part} COMMAND tests/checks/refuses tests/checks/seeded/${name}.c)
endforeach()

# A program whose output depends on the byte order must be refused.
sheen_script(seeded_byte_order cross COMMAND tests/checks/refuses "powerpc differs from gcc-O2"
  tests/checks/cross tests/checks/seeded/byte_order gcc-O2 powerpc)

add_library(seeded_name STATIC checks/seeded/rules_name.c)
sheen_script(seeded_names format COMMAND tests/checks/refuses "does not start with sheen_: seed"
  tests/checks/names $<TARGET_FILE:seeded_name>)

# A page whose second command fails, and a page that lacks a command which it should give.
sheen_script(seeded_readme_fails format COMMAND tests/checks/refuses "1 passed, 1 failed"
  tests/checks/readme tests/checks/seeded/readme_fails.md)
sheen_script(seeded_readme_lacks format COMMAND tests/checks/refuses "does not give the command tests/run"
  tests/checks/readme --done tests/run tests/checks/seeded/readme_fails.md)

# The README's first command on a system where nothing is installed.
sheen_script(bare bare COMMAND tests/bare/run $<TARGET_FILE:sheen>)
