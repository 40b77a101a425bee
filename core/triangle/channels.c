/*
 * channels.c - set-up of colours that change freely from corner to corner.
 */
#include "quotient.h"

/* 1 if perspective changes a channel by at most 3/64 of a 64th of 1.0, as with Gouraud's colours. */
static int is_straight(const struct surface_corners *c, const struct colour_terms *terms, int32_t d1, int32_t d2)
{
    return sheen_straight(c, d1, d2, 3u << terms->unit_log2 >> 20);
}

/* 1 if perspective shows in no channel and, on grey targets, where the sum is what counts, not in their sum. */
static int channels_straight(const struct setup *s, const struct surface_corners *c, uint32_t channel[3][3])
{
    const struct colour_terms *terms = &s->draw->colour;
    int32_t sum[2] = {0, 0};
    int straight = way_wanted(s->draw, SHEEN_WAY_GOURAUD_LINEAR);

    for (int i = 0; i < 3 && straight; i++) {
        const int32_t d1 = cut_difference(channel[i][1], channel[i][0]),
                      d2 = cut_difference(channel[i][2], channel[i][0]);
        sum[0] += d1;
        sum[1] += d2;
        straight = is_straight(c, terms, d1, d2);
    }
    if (!straight || s->draw->is_565)
        return straight;
    return (magnitude32(sum[0]) | magnitude32(sum[1])) <= STEEPEST_DIFFERENCE && is_straight(c, terms, sum[0], sum[1]);
}

static int all_equal(uint32_t channel[3][3])
{
    unsigned apart = 0;

    for (int i = 0; i < 3; i++)
        apart |= (channel[i][0] ^ channel[i][1]) | (channel[i][0] ^ channel[i][2]);
    return apart == 0;
}

HOT void sheen_setup_channels(struct setup *s, struct surface_corners *c, const struct gradients *g,
                              uint32_t channel[3][3])
{
    if (g == NULL || all_equal(channel)) {
        uint32_t mean[3];
        for (int i = 0; i < 3; i++) {
            const uint32_t *f = channel[i];
            mean[i] = f[0] + (uint32_t)((int32_t)(f[1] - f[0]) / 3 + (int32_t)(f[2] - f[0]) / 3);
        }
        sheen_setup_colour(s, mean);
    } else if (channels_straight(s, c, channel)) {
        s->way = SHEEN_WAY_GOURAUD_LINEAR;
        sheen_setup_linear(s, g, channel);
    } else {
        sheen_weigh(c);
        sheen_setup_quotient(s, c, g, channel);
    }
}
