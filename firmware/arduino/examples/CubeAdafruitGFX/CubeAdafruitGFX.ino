// CubeAdafruitGFX: sheen draws, a colour driver of Adafruit GFX sends. ILI9341, ST7735, SSD1351 work the same way.
#include <Adafruit_ST7789.h>
#include <sheen_arduino.h>
#include "example.h" // with cube.c beside it: draws the cube

Adafruit_ST7789 tft(10, 9, 8); // CS, D/C, reset
sheen_target target;

void setup()
{
    tft.init(240, 240);
    sheen_draw_bitmap(&target, tft);
}

void loop()
{
    example(&target, 60);
}
