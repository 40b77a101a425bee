/*
 * sheen_arduino.h - sheen in a sketch: a panel on SPI.h, or a display library's own object as the target.
 *
 * SheenSPI drives a panel of sheen_panel.h. If a display library drives the panel already, sheen_push_image()
 * (TFT_eSPI, LovyanGFX) or sheen_draw_bitmap() (Adafruit GFX) fills in the target, and no driver of sheen is linked.
 */
#ifndef SHEEN_ARDUINO_H
#define SHEEN_ARDUINO_H

#include <Arduino.h>
#include <SPI.h>
#include <string.h>

#include "sheen.h"
#include "sheen_panel.h"

/* A panel on hardware SPI. Do not move the object after begin(). */
class SheenSPI
{
  public:
    sheen_panel panel;   /* for sheen_panel_brightness() and the like */
    sheen_target target; /* for sheen_config */

    /* Pin numbers; cs and reset: -1 if the module has no such pin. */
    SheenSPI(int dc, int cs, int reset, SPIClass &spi = SPI) : dc_(dc), cs_(cs), reset_(reset), spi_(spi)
    {
    }

    /* orientation: 0..7 (sheen_panel.h); clock: Hz, 0: the record's. Returns 0 or a code of enum sheen_error. */
    int begin(const sheen_panel_record &record, unsigned orientation = 0, uint32_t clock = 0)
    {
        clock_ = clock ? clock : record.clock_hz;
        mode_ = record.spi_mode == 3 ? SPI_MODE3 : SPI_MODE0;
        pinMode(dc_, OUTPUT);
        if (cs_ >= 0) {
            pinMode(cs_, OUTPUT);
            digitalWrite(cs_, HIGH);
        }
        if (reset_ >= 0)
            pinMode(reset_, OUTPUT);
        spi_.begin();
        bus_ = sheen_bus();
        bus_.ctx = this;
        bus_.send = send;
        bus_.delay = wait_us;
        bus_.reset = reset_ >= 0 ? reset : NULL;
        int error = sheen_panel_open(&panel, &record, &bus_, orientation);
        return error < 0 ? error : sheen_panel_target(&panel, &target);
    }

  private:
    /* Sends from a copy, because SPI.transfer() overwrites its buffer with what it receives. */
    void put(int dc, const void *bytes, size_t count)
    {
        uint8_t part[64];

        digitalWrite(dc_, dc ? HIGH : LOW); /* an enum, not a number, in cores on ArduinoCore-API */
        for (size_t at = 0, n; at < count; at += n) {
            n = count - at < sizeof part ? count - at : sizeof part;
            memcpy(part, (const uint8_t *)bytes + at, n);
            spi_.transfer(part, n);
        }
    }

    static int send(void *ctx, const uint8_t *command, size_t commands, const void *data, size_t count)
    {
        SheenSPI *self = (SheenSPI *)ctx;

        self->spi_.beginTransaction(SPISettings(self->clock_, MSBFIRST, self->mode_));
        if (self->cs_ >= 0)
            digitalWrite(self->cs_, LOW);
        self->put(0, command, commands);
        self->put(1, data, count);
        if (self->cs_ >= 0)
            digitalWrite(self->cs_, HIGH);
        self->spi_.endTransaction();
        return SHEEN_OK;
    }

    static int wait_us(void *, uint32_t us)
    {
        if (us >= 1000)
            delay(us / 1000 + 1); /* one more, because delay() counts ticks and the first may come at once */
        delayMicroseconds(us % 1000);
        return SHEEN_OK;
    }

    static int reset(void *ctx, int level)
    {
        digitalWrite(((SheenSPI *)ctx)->reset_, level ? HIGH : LOW);
        return SHEEN_OK;
    }

    sheen_bus bus_;
    int dc_, cs_, reset_, mode_;
    uint32_t clock_;
    SPIClass &spi_;
};

/* Fills in a target; used by sheen_push_image() and sheen_draw_bitmap(). */
template <class Display>
void sheen_display_target(sheen_target *target, Display &display, uint8_t pixel,
                          int (*push)(void *, sheen_rect, const void *))
{
    *target = sheen_target();
    target->ctx = &display;
    target->push = push;
    target->width = (uint16_t)display.width();
    target->height = (uint16_t)display.height();
    target->pixel = pixel;
}

/* The push of sheen_push_image(). */
template <class Display> int sheen_pushes_image(void *display, sheen_rect r, const void *pixels)
{
    ((Display *)display)->pushImage(r.x0, r.y0, r.x1 - r.x0, r.y1 - r.y0, (uint16_t *)const_cast<void *>(pixels));
    return SHEEN_OK;
}

/* The push of sheen_draw_bitmap(). */
template <class Display> int sheen_draws_bitmap(void *display, sheen_rect r, const void *pixels)
{
    ((Display *)display)->drawRGBBitmap(r.x0, r.y0, (uint16_t *)const_cast<void *>(pixels), r.x1 - r.x0, r.y1 - r.y0);
    return SHEEN_OK;
}

/* Target for TFT_eSPI and LovyanGFX, after setRotation(). Their setSwapBytes() MUST be false, which is the default. */
template <class Display> void sheen_push_image(sheen_target *target, Display &display)
{
    sheen_display_target(target, display, SHEEN_RGB565_BE, sheen_pushes_image<Display>);
}

/* Target for colour displays of Adafruit GFX, after setRotation(). Its pixels are in the processor's byte order. */
template <class Display> void sheen_draw_bitmap(sheen_target *target, Display &display)
{
    sheen_display_target(target, display, SHEEN_RGB565_LE, sheen_draws_bitmap<Display>);
}

#endif
