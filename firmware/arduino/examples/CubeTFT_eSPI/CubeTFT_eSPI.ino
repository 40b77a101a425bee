// CubeTFT_eSPI: sheen draws, TFT_eSPI drives the panel that it is set up for.
#include <TFT_eSPI.h>
#include <sheen_arduino.h>
#include "example.h" // with cube.c beside it: draws the cube

TFT_eSPI tft;
sheen_target target;

void setup()
{
    tft.begin();
    tft.setRotation(0);
    sheen_push_image(&target, tft);
}

void loop()
{
    example(&target, 60);
}
