/*
 * test_edges.c - the columns where edges cross rows, against exact integers.
 *
 *   test_edges        a sample
 *   test_edges all    every short edge: widths up to 2048/64 px, heights below that, every start between two rows
 *
 * It is built once for each form of edge.c (with and without SHEEN_NO_DIVIDER). The fraction of the column at which an
 * edge starts is random, because both forms add it exactly. Long random edges are tested too, and edges that begin
 * above the tile or continue in the next tile.
 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "triangle/triangle.h"

#define SHORT 2048     /* 1/64 px, as in edge.c */
#define FARTHEST 32704 /* 1/64 px from the viewport's centre to a vertex: the guard band's 511 px */
#define WIDEST 40960   /* 1/64 px, a target 640 px wide, which contains its viewport's centre */
#define MOST_ROWS 1024
#define LONG_EDGES 300000

static struct span spans[MOST_ROWS];
static uint64_t crossings, wrong;
static uint32_t lot_state = 1;

static uint32_t lot(uint32_t below)
{
    lot_state ^= lot_state << 13;
    lot_state ^= lot_state >> 17;
    lot_state ^= lot_state << 5;
    return (uint32_t)((uint64_t)lot_state * below >> 32);
}

static int32_t first_row(int32_t y)
{
    return asr32(y + 31, 6);
}

/* Checks that `column` is the least integer >= (x - 32 + width (64 row + 32 - y) / height) / 64. */
static void check(const struct screen_corner *upper, int32_t width, int32_t height, int32_t row, int32_t column)
{
    int64_t above = (int64_t)(upper->x - 32) * height + (int64_t)width * (64 * row + 32 - upper->y);
    int64_t unit = 64 * (int64_t)height;

    crossings++;
    if (unit * (column - 1) < above && above <= unit * column)
        return;
    if (wrong++ < 10)
        printf("  column %d is wrong in row %d of the edge from (%d, %d) by (%d, %d) in 1/64 px\n", column, row,
               upper->x, upper->y, width, height);
}

/* From row `next`, steps an edge that may be needed again back to the row where it began in its tile. */
static void walk_back(const struct screen_corner *upper, int32_t width, int32_t height, const struct edge *e,
                      int32_t first, int32_t next)
{
    int64_t at = whole_of(e->at);

    for (int32_t row = next - 1; row >= first; row--) {
        at -= whole_of(e->step);
        check(upper, width, height, row, (int32_t)(at >> 32));
    }
}

/*
 * Steps an edge down and back, as the sides of a triangle without area, in tiles of `rows` rows. The first tile begins
 * at row `from`. rows 0: the whole triangle lies in one tile.
 */
static void walk(int32_t x, int32_t y, int32_t width, int32_t height, int32_t from, int32_t rows)
{
    const struct screen_corner upper = {x, y, first_row(y)}, lower = {x + width, y + height, first_row(y + height)};
    const struct screen_corner at[3] = {lower, lower, upper};
    struct edge_rows to = {rows ? from : upper.row, rows ? from + rows : lower.row, rows == 0, 0};
    struct setup s = {.end_row = (int16_t)lower.row};

    if (upper.row == lower.row)
        return;
    s.right = right_edges(sheen_edges_begin(s.edge, at, &to, spans), 0);
    for (;;) {
        for (int32_t row = max32(upper.row, to.row); row < min32(lower.row, to.end); row++) {
            check(&upper, width, height, row, spans[row - to.row].x0);
            check(&upper, width, height, row, spans[row - to.row].x1);
        }
        if (!to.whole && to.end > upper.row && to.row < lower.row)
            walk_back(&upper, width, height, &s.edge[0], max32(upper.row, to.row), min32(lower.row, to.end));
        if (to.end >= lower.row)
            return;
        to.row = to.end;
        to.end += rows;
        s.row = (int16_t)to.row;
        (void)sheen_spans(&s, (struct sheen_rect){.y1 = (int16_t)to.end}, spans);
    }
}

static void short_edges(int all)
{
    for (int32_t height = 1; height < SHORT; height += 1) {
        int32_t sparse = all || height < 70 || height > 1980 || height % 64 == 0 ? 1 : 41;
        for (int32_t width = -SHORT + (int32_t)lot((uint32_t)sparse); width < SHORT; width += sparse) {
            for (int32_t rest = all ? 0 : (int32_t)lot(29); rest < 64; rest += all ? 1 : 29)
                walk((int32_t)lot(64), 32 - rest, width, height, 0, width & 1 ? 0 : 1 + (int32_t)lot(40));
        }
    }
}

/* Random edges with both ends in the guard band, half of them nearly horizontal or nearly vertical, in random tiles. */
static void any_edges(void)
{
    for (int i = 0; i < LONG_EDGES; i++) {
        int32_t reach = 64 << lot(10), y = (int32_t)lot(2 * FARTHEST) - FARTHEST;
        int32_t x = (int32_t)lot(2 * FARTHEST) - FARTHEST, width, height;
        width = i & 1 ? (int32_t)lot(2 * FARTHEST) - FARTHEST - x : (int32_t)lot((uint32_t)(2 * reach)) - reach;
        height = i & 2 ? (int32_t)lot((uint32_t)(FARTHEST - y)) + 1 : (int32_t)lot((uint32_t)reach) + 1;
        int32_t from = first_row(y) - 8 + (int32_t)lot(24), rows = 1 + (int32_t)lot(64);
        if (x + width > -FARTHEST && x + width < FARTHEST && y + height < FARTHEST)
            walk(x + (int32_t)lot(WIDEST), y, width, height, from, i % 3 ? rows : 0);
    }
}

int main(int argc, char **argv)
{
    short_edges(argc > 1 && strcmp(argv[1], "all") == 0);
    any_edges();
    printf("%" PRIu64 " crossings, %" PRIu64 " wrong\n", crossings, wrong);
    return wrong != 0;
}
