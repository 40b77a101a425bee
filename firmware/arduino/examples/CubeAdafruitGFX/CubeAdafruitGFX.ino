// CubeAdafruitGFX: sheen draws, a colour driver on Adafruit GFX sends it: ILI9341, ST7735, SSD1351 alike.
#include <Adafruit_ST7789.h>
#include <sheen_arduino.h>
#include "example.h" // and cube.c beside it: what is drawn

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
