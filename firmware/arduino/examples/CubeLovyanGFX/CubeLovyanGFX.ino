// CubeLovyanGFX: sheen draws, LovyanGFX drives the panel. LGFX is your class for the panel, or LGFX_AUTODETECT's.
#include <LovyanGFX.hpp>
#include <sheen_arduino.h>
#include "example.h" // with cube.c beside it: draws the cube

LGFX lcd;
sheen_target target;

void setup()
{
    lcd.init();
    lcd.setRotation(0);
    sheen_push_image(&target, lcd);
}

void loop()
{
    example(&target, 60);
}
