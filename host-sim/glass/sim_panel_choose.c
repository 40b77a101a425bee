/*
 * sim_panel_choose.c - chooses the orientation and size in which a panel is viewed.
 */
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "nearest.h"
#include "sim_panel.h"

#define IDEAL_MIN 8u
#define IDEAL_MAX_W 640u
#define IDEAL_MAX_H 480u

static int choose_ideal(struct sheen_sim_choice *choice, int orientation, unsigned width, unsigned height, char *why,
                        size_t why_size)
{
    if (width == 0)
        width = 320, height = 240;
    if (width < IDEAL_MIN || height < IDEAL_MIN || width > IDEAL_MAX_W || height > IDEAL_MAX_H) {
        snprintf(why, why_size, "ideal takes sizes from %ux%u to %ux%u, not %ux%u", IDEAL_MIN, IDEAL_MIN, IDEAL_MAX_W,
                 IDEAL_MAX_H, width, height);
        return SHEEN_ERR_ARGUMENT;
    }
    *choice = (struct sheen_sim_choice){.orientation = orientation < 0 ? 0 : (unsigned)orientation,
                                        .width = (uint16_t)width,
                                        .height = (uint16_t)height};
    return SHEEN_OK;
}

/* Writes the error line with the sizes that the panel can have: "320x240", or both ways round. */
static void refuse_size(const struct sheen_sim_choice *choice, int given, unsigned width, unsigned height, char *why,
                        size_t why_size)
{
    uint16_t w, h;

    if (given) {
        snprintf(why, why_size, "%s in orientation %u is %ux%u, not %ux%u", choice->record->name, choice->orientation,
                 choice->width, choice->height, width, height);
        return;
    }
    sheen_panel_size(choice->record, 0, &w, &h);
    if (w == h)
        snprintf(why, why_size, "%s is %ux%u, not %ux%u", choice->record->name, w, h, width, height);
    else
        snprintf(why, why_size, "%s is %ux%u or %ux%u, not %ux%u", choice->record->name, w, h, h, w, width, height);
}

int sheen_sim_choose(struct sheen_sim_choice *choice, const char *panel, int orientation, unsigned width,
                     unsigned height, char *why, size_t why_size)
{
    if (orientation < -1 || orientation > 7 || (width == 0) != (height == 0)) {
        snprintf(why, why_size, "orientation %d, size %ux%u: out of range", orientation, width, height);
        return SHEEN_ERR_ARGUMENT;
    }
    if (strcasecmp(panel, "ideal") == 0)
        return choose_ideal(choice, orientation, width, height, why, why_size);

    *choice = (struct sheen_sim_choice){.record = sheen_panel_find(panel)};
    if (!choice->record) {
        struct sheen_nearest nearest = {.word = panel};
        sheen_nearest_panel(&nearest);
        sheen_nearest_try(&nearest, "ideal", strlen("ideal"));
        snprintf(why, why_size, "no panel is called '%s'; the nearest is %.*s (`sheen panels` lists them)", panel,
                 nearest.length, nearest.name);
        return SHEEN_ERR_ARGUMENT;
    }
    choice->orientation = orientation >= 0 ? (unsigned)orientation
                          : width          ? 0
                                           : sheen_panel_default_orientation(choice->record);
    sheen_panel_size(choice->record, choice->orientation, &choice->width, &choice->height);
    if (width == 0 || (choice->width == width && choice->height == height))
        return SHEEN_OK;
    if (orientation < 0 && choice->height == width && choice->width == height) {
        /* The size is not orientation 0's but orientation 1's, the quarter turn. */
        choice->orientation = 1;
        choice->width = (uint16_t)width;
        choice->height = (uint16_t)height;
        return SHEEN_OK;
    }
    refuse_size(choice, orientation >= 0, width, height, why, why_size);
    return SHEEN_ERR_ARGUMENT;
}

unsigned sheen_sim_frame_bytes(const struct sheen_panel_record *record)
{
    unsigned bytes = record->glass_h * sheen_row_bytes((enum sheen_pixel)record->pixel, record->glass_w);

    return record->bits_18 ? bytes / 2 * 3 : bytes;
}
