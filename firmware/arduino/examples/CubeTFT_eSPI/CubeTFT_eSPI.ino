// CubeTFT_eSPI: sheen draws, TFT_eSPI drives the panel that it is set up for.
#include <TFT_eSPI.h>
#include <sheen_arduino.h>
#include "example.h" // with cube.c beside it: draws the cube

TFT_eSPI tft;
sheen_target target;
sheen_frame *frame;
int error;

void setup()
{
    Serial.begin(115200);
    tft.begin();
    tft.setRotation(0);
    sheen_push_image(&target, tft);
    error = example_init(&frame, &target);
    Serial.println(sheen_strerror(error));
}

void loop()
{
    static unsigned i;

    if (!error)
        error = example_draw(frame, i++);
}
