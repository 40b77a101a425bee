# The Linux board: the pin watcher, and what of hal/linux and sheen-panel needs no GPIO.
sheen_test(test_pin_watcher sim SOURCES test_pin_watcher.c LIBRARIES sheen::sim)
sheen_test(test_panel_off panel SOURCES test_panel_off.c LIBRARIES sheen::sim)
