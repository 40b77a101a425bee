/*
 * clip.c - triangles that leave the view volume are cut in eye space, once, in draw().
 */
#include "stages.h"

int sheen_clip(struct sheen_frame *f, const struct draw_record *d, const struct transform *t, uint16_t triangle)
{
    (void)f; (void)d; (void)t; (void)triangle;
    return 0;
}
