// CubeLovyanGFX: sheen draws, LovyanGFX drives the panel. LGFX is your class for the panel, or LGFX_AUTODETECT's.
#include <LovyanGFX.hpp>
#include <sheen_arduino.h>
#include "example.h" // with cube.c beside it: draws the cube

LGFX lcd;
sheen_target target;
sheen_frame *frame;
int error;

void setup()
{
    Serial.begin(115200);
    lcd.init();
    lcd.setRotation(0);
    sheen_push_image(&target, lcd);
    error = example_init(&frame, &target);
    Serial.println(sheen_strerror(error));
}

void loop()
{
    static unsigned i;

    if (!error)
        error = example_draw(frame, i++);
}
