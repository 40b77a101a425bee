// CubeAdafruitGFX: sheen draws, a colour driver of Adafruit GFX sends. ILI9341, ST7735, SSD1351 work the same way.
#include <Adafruit_ST7789.h>
#include <sheen_arduino.h>
#include "example.h" // with cube.c beside it: draws the cube

Adafruit_ST7789 tft(10, 9, 8); // CS, D/C, reset
sheen_target target;
sheen_frame *frame;
int error;

void setup()
{
    Serial.begin(115200);
    tft.init(240, 240);
    sheen_draw_bitmap(&target, tft);
    error = example_init(&frame, &target);
    Serial.println(sheen_strerror(error));
}

void loop()
{
    static unsigned i;

    if (!error)
        error = example_draw(frame, i++);
}
