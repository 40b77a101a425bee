# The simulator below the panel drivers: controllers, bus, glass.
target_sources(sheen_sim PRIVATE
  glass/controller.c
  glass/controller_dcs.c
  glass/controller_grey.c
  glass/controller_ideal.c
  glass/controller_mono.c
  glass/controller_oled.c
  glass/controller_ssd1322.c
  glass/controller_ssd1351.c
  glass/glass.c
  glass/i2c_watcher.c
  glass/sim_bus.c
  glass/sim_panel.c
  glass/sim_panel_choose.c
  glass/sim_panel_ideal.c
  glass/sim_panel_modules.c
  import/nearest.c
  glass/pin_watcher.c
)
