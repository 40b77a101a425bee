# Simulated controllers and bus first, then the drivers on top of them.
sheen_test(test_bus sim SOURCES test_bus.c LIBRARIES sheen_sim)
sheen_test(test_controller_dcs sim SOURCES test_controller_dcs.c LIBRARIES sheen_sim)
sheen_test(test_controller_oled sim SOURCES test_controller_oled.c LIBRARIES sheen_sim)

sheen_script(cli_panels ${many} COMMAND tests/cli/panels $<TARGET_FILE:sheen>)

foreach(name test_panel test_panel_corners test_panel_faults test_panel_first_light test_panel_settings test_i2c)
  sheen_test(${name} panel SOURCES ${name}.c test_panel_canvas.c LIBRARIES sheen_sim sheen_hal)
endforeach()
target_sources(test_panel_settings PRIVATE ${PROJECT_SOURCE_DIR}/firmware/examples/own_module/record.c)
sheen_test(test_panel_wire panel SOURCES test_panel_wire.c LIBRARIES sheen_hal)
sheen_test(test_panel_teapot panel SOURCES test_panel_teapot.c test_panel_canvas.c memory_target.c
  LIBRARIES sheen_sim sheen_hal sheen_host sheen::core)
