/*
 * marks.c - pixels that contours cross: all lines mark theirs first, then each is mixed with what its neighbours were
 * before.
 *
 * So a pixel depends on the triangles around it and on the contours that cross it and its neighbours, but not on the
 * order of lines, on other smoothed pixels or on the band.
 */
#include "lines.h"

/*
 * A mark. Bits 0 and 1: the neighbour of which the pixel takes a share; bits 2 to 6: that share in 1/64, in inside
 * marks MOST_SHARE minus it; MARK_INSIDE: the pixel belongs to what the contour bounds. A pixel keeps its largest mark:
 * an inside one before others, then the one whose surface covers most, because surfaces behind others have contours
 * too, and the outermost is seen.
 */
#define FROM_LEFT 0u
#define FROM_RIGHT 1u
#define FROM_ABOVE 2u
#define FROM_BELOW 3u
#define MOST_SHARE 31
#define MARK_INSIDE 0x80u

/* share: 0..MOST_SHARE. */
static inline uint32_t inside_mark(uint32_t from, int32_t share)
{
    return MARK_INSIDE | (uint32_t)(MOST_SHARE - share) << 2 | from;
}

static inline uint32_t marked_share(uint32_t mark)
{
    uint32_t share = mark >> 2 & MOST_SHARE;

    return (mark & MARK_INSIDE) != 0 ? MOST_SHARE - share : share;
}

/* What lies beyond a contour is farther away by more than this many steps of z16. */
#define BEYOND 32

/* A share, 0..MOST_SHARE, reduced if `beyond`, > 0, is small: a contour that ends in a surface fades out gradually. */
static inline int32_t share_beyond(const struct line_tile *lt, int32_t share, int32_t beyond)
{
    return share * min32(beyond, 1 << lt->whole_bits) >> lt->whole_bits;
}

/* x and y in the tile; rows of the apron have no marks. */
static APART void set_mark(const struct line_tile *lt, int32_t x, int32_t y, uint32_t value)
{
    const uint32_t row = (uint32_t)(y - lt->apron);

    if (row >= lt->rows)
        return;
    uint8_t *mark = lt->marks + row * MARK_PITCH(lt->tile->pitch) + (uint32_t)x;
    struct span *touched = &lt->touched[row];
    if (*mark >= value)
        return;
    *mark = (uint8_t)value;
    if (x < touched->x0)
        touched->x0 = (int16_t)x;
    if (x > touched->x1)
        touched->x1 = (int16_t)x;
}

/*
 * A crossed pixel that is farther away than the contour and than its neighbour inside lies beyond the contour: it takes
 * a share of that neighbour, which itself takes no share of what is beyond. Any other crossed pixel belongs to the
 * inside and takes a share of its neighbour beyond. Only pixels with both neighbours in the tile are mixed.
 */
SPECIALISED void smooth_rows(const struct line_tile *lt, const struct steps *s, int steep)
{
    const struct tile *t = lt->tile;
    const int32_t pitch = (int32_t)t->pitch, size = steep ? pitch : t->rect.y1 - t->rect.y0;
    const int32_t low = s->low_inside, in = low ? -1 : 1, next = steep ? in : low ? -pitch : pitch;
    const uint32_t beyond = (steep ? FROM_LEFT : FROM_ABOVE) | (uint32_t)low, flip = low ? 0 : 0xffff;
    int32_t across = s->across - (steep ? t->rect.x0 : t->rect.y0) * 65536, z = s->z;
    int32_t along = s->first - (steep ? t->rect.y0 : t->rect.x0), end = s->end - s->first + along;

    SHEEN_TAP(SMOOTH_STEP, end - along);
    for (; along < end; along++, across += s->across_step, z += s->z_step) {
        const int32_t place = asr32(across, 16);
        if ((uint32_t)(place - low) >= (uint32_t)(size - 1)) /* its neighbour inside is not in the tile */
            continue;
        const int32_t x = steep ? place : along, y = steep ? along : place;
        const uint16_t *depth = t->depth + y * pitch + x;
        const int32_t own = depth[0], inside = depth[next], edge_z = asr32(z, 8);
        const int32_t covered = (int32_t)(((((uint32_t)across ^ flip) & 0xffff) + 512) >> 10); /* 0..64 */
        const int mixed = (uint32_t)(place - in) < (uint32_t)size;
        const int32_t ahead = min32(inside, edge_z) - own;
        if (ahead > BEYOND) {
            const int32_t share = share_beyond(lt, min32(covered, MOST_SHARE), ahead);
            if (mixed && share > 0)
                set_mark(lt, x, y, (uint32_t)share << 2 | (beyond ^ 1));
            set_mark(lt, steep ? x + in : x, steep ? y : y + in, inside_mark(beyond, 0));
        } else if (mixed) {
            const int32_t behind = min32(own, edge_z) - depth[-next];
            if (behind > BEYOND)
                set_mark(lt, x, y, inside_mark(beyond, share_beyond(lt, min32(64 - covered, MOST_SHARE), behind)));
        }
    }
}

HOT void sheen_smooth_rows(const struct line_tile *t, const struct steps *s)
{
    if (s->steep)
        smooth_rows(t, s, 1);
    else
        smooth_rows(t, s, 0);
}

/*
 * A pixel mixed with `share` / 64 of its neighbour at offset `from`. The rest is the pixel's own and the opposite
 * neighbour's; their parts become equal as the contour nears the pixel's centre. So the colour jumps less when the
 * contour passes that: until then the rest was the other surface's, or was drawn in the pixel beside.
 */
static APART uint32_t mixed_565(const uint16_t *p, int32_t from, uint32_t share, unsigned swap)
{
    const uint32_t odd = 0xf81fu, even = 0x07e0u;
    uint32_t side = (64 - share) * share >> 6, pixel = pixel_order(p[from], swap), red_blue, green;

    red_blue = 0x10020u + (pixel & odd) * share; /* fields of 5 and 6 bits times 64 do not overlap */
    green = 0x0400u + (pixel & even) * share;
    pixel = pixel_order(p[-from], swap);
    red_blue += (pixel & odd) * side;
    green += (pixel & even) * side;
    pixel = pixel_order(p[0], swap);
    side = 64 - share - side;
    red_blue += (pixel & odd) * side;
    green += (pixel & even) * side;
    return pixel_order((red_blue >> 6 & odd) | (green >> 6 & even), swap);
}

static inline uint32_t mixed_grey(const uint8_t *p, int32_t from, uint32_t share)
{
    const uint32_t side = (64 - share) * share >> 6;

    return (p[from] * share + p[-from] * side + p[0] * (64 - share - side) + 32) >> 6;
}

/* List what the marked pixels of a row become, and clear the marks; returns the end of the list. */
static struct mixed *mix_row(const struct line_tile *lt, uint32_t row, uint32_t line, struct mixed *list)
{
    const struct tile *t = lt->tile;
    const int32_t pitch = (int32_t)t->pitch;
    uint8_t *mark = lt->marks + row * MARK_PITCH(t->pitch);
    const uint32_t end = (uint32_t)(lt->touched[row].x1 + 1);

    for (uint32_t word = (uint32_t)lt->touched[row].x0 & ~3u; word < end; word += 4) {
        if (*(uint32_t *)(void *)(mark + word) == 0)
            continue;
        for (uint32_t x = word; x < word + 4; x++) {
            const uint32_t value = mark[x], share = marked_share(value);
            if (value == 0 || share == 0)
                continue;
            int32_t from = (value & FROM_ABOVE) != 0 ? pitch : 1;
            if ((value & FROM_RIGHT) == 0)
                from = -from;
            list->x = (uint16_t)x;
            list->pixel = (uint16_t)(t->format->grey ? mixed_grey((const uint8_t *)t->pixels + line + x, from, share)
                                                     : mixed_565((const uint16_t *)t->pixels + line + x, from, share,
                                                                 t->format->swap));
            list++;
        }
        *(uint32_t *)(void *)(mark + word) = 0;
    }
    return list;
}

/* Write the mixed pixels of a row, once no other row is mixed from the old ones. */
static void put_row(const struct tile *t, uint32_t line, const struct mixed *list, const struct mixed *end)
{
    for (; list != end; list++)
        if (t->format->grey)
            ((uint8_t *)t->pixels)[line + list->x] = (uint8_t)list->pixel;
        else
            ((uint16_t *)t->pixels)[line + list->x] = list->pixel;
}

HOT void sheen_smooth_finish(const struct line_tile *lt)
{
    const uint32_t pitch = lt->tile->pitch;
    struct mixed *above = lt->mixed, *end = above;
    uint32_t line = (uint32_t)lt->apron * pitch;

    for (uint32_t row = 0; row < lt->rows; row++, line += pitch) {
        struct mixed *list = above == lt->mixed ? above + pitch : lt->mixed, *mixed = mix_row(lt, row, line, list);
        put_row(lt->tile, line - pitch, above, end);
        SHEEN_TAP(SMOOTH_ROW, 1);
        SHEEN_TAP(MIXED, mixed - list);
        above = list;
        end = mixed;
    }
    put_row(lt->tile, line - pitch, above, end);
}
