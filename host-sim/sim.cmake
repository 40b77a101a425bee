# The simulator below the panel drivers: controllers, bus, glass.
target_sources(sheen_sim PRIVATE
  controller.c
  controller_dcs.c
  controller_grey.c
  controller_ideal.c
  controller_mono.c
  controller_oled.c
  controller_ssd1322.c
  controller_ssd1351.c
  glass.c
  i2c_watcher.c
  sim_bus.c
  sim_panel.c
  sim_panel_choose.c
  sim_panel_ideal.c
  sim_panel_modules.c
  nearest.c
  pin_watcher.c
)
