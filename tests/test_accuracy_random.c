/*
 * test_accuracy_random.c - pictures of random poses, lights and colours against the picture in double precision.
 *
 *   test_accuracy_random PICTURES [FIRST [RATIO]]
 *
 * RATIO: moves the near plane so that the far one is RATIO times as far away, and leaves out fog and bias. 1/m is
 * derived from the depth, whose steps are coarse then: from about 300 on, one picture in a thousand has too few equal
 * pixels.
 *
 * It covers what test_accuracy's views do not: light from behind, shininess from 1, strong highlights on coarse meshes,
 * cuts by the guard band, dither, any way forced, texels, fog, pixels left out (random_scene.c). A picture depends on
 * its number alone, so one that is outside the limits can be drawn again by `test_accuracy_random 1 NUMBER`.
 *
 * Every picture keeps the limits of its shading, with these differences. Where light is computed at corners and
 * polygons, the 16 bits of one normal move a highlight of n = 128 by some .07 level, over as many pixels as there are
 * around it; so do the 15 bits of a root a pixel where that way is forced on a magnified triangle. So in flat and
 * Gouraud, and where a way is forced, the share of equal pixels is that of all pictures of a kind together. An area
 * of one colour that lies on a rounding edge is all equal or all unequal by a hair: a picture that has too few equal
 * pixels is drawn once more with dither and with no pixel left out (those that are kept have few thresholds), which
 * takes the edge away, and its share is judged by that. Slerp is judged where no triangle was cut.
 */
#include <stdio.h>
#include <stdlib.h>

#include "random_scene.h"

static const char *const kind_name[RANDOM_KINDS] = {"any", "from behind", "strong highlight", "guard band", "known"};
static const char *const shading_name[] = {"flat", "gouraud", "phong", "slerp"};

/* The results of one kind and shading. */
static struct row {
    long pictures, compared, equal;
    double lowest, lowest_within_one;
    int worst;
    uint32_t lowest_at;
} rows[RANDOM_KINDS][4];

static long ties; /* pictures judged by their dithered likeness */

static double share(long part, long whole)
{
    return (double)part / (double)whole;
}

static void add(struct row *row, const struct ref_score *score, uint32_t number)
{
    double equal = share(score->equal, score->compared), within_one = share(score->within_one, score->compared);

    if (row->pictures == 0 || equal < row->lowest) {
        row->lowest = equal;
        row->lowest_at = number;
    }
    if (row->pictures == 0 || within_one < row->lowest_within_one)
        row->lowest_within_one = within_one;
    row->pictures++;
    row->compared += score->compared;
    row->equal += score->equal;
    row->worst = score->worst > row->worst ? score->worst : row->worst;
}

/* Fewer pixels than these tell nothing: a share of them is that of a handful. */
#define FEWEST 2000

/* Fog may be off by a step more; what is left out, or of no colour, is not drawn. */
static int is_off(const struct ref_score *score, const struct ref_scene *scene)
{
    const struct accuracy_limit *limit = &accuracy_limits[scene->shading];

    return share(score->within_one, score->compared) < limit->within_one || score->worst > limit->worst + scene->fog ||
           score->dropped_drawn > 0;
}

static int has_few_equal(const struct ref_score *score, const struct random_scene *random)
{
    enum ref_shading shading = random->scene.shading;

    return shading != REF_FLAT && shading != REF_GOURAUD && random->way == 0 &&
           share(score->equal, score->compared) < (random->scene.fog ? 0.95 : accuracy_limits[shading].equal);
}

/* The reference and the core's picture of it: 0, or negative where one cannot be drawn. */
static int shoot(struct accuracy_shot *shot, const struct random_scene *random)
{
    struct ref_picture picture;

    if (ref_render(&picture, &random->scene) != 0)
        return -1;
    int status = accuracy_shoot(shot, &random->scene, &picture, random->mesh->mesh, random->way);
    ref_picture_free(&picture);
    return status;
}

/* Moves the near plane nearer, unless it is near enough already. */
static void deepen(struct ref_scene *scene, double ratio)
{
    scene->near = ratio * scene->near > scene->far ? scene->far / ratio : scene->near;
    scene->fog = false; /* its planes may be too few steps apart then, */
    scene->bias = 0;    /* and what is moved by so many of them beyond the far plane */
}

/* 1 where the picture is outside its limits. ratio: of far to near at the least; 0: as it is. */
static int judge(const struct random_meshes *meshes, uint32_t number, double ratio)
{
    static struct accuracy_shot shot, dithered;
    struct random_scene random;
    const struct ref_score *score = &shot.score;

    random_scene(&random, meshes, number);
    if (ratio > 0)
        deepen(&random.scene, ratio);
    enum ref_shading shading = random.scene.shading;
    int failed = shoot(&shot, &random) < 0;
    if (failed) {
        printf("  FAILED picture %u not drawn\n", number);
    } else if (score->compared >= FEWEST && !(shading == REF_SLERP && shot.stats.frame.clipped > 0)) {
        int few = has_few_equal(score, &random);
        if (few && (!random.scene.dither || random.scene.left_out > 0)) {
            random.scene.dither = true;
            random.scene.left_out = 0;
            few = shoot(&dithered, &random) < 0 || has_few_equal(&dithered.score, &random);
            ties += !few;
        }
        if (few || !has_few_equal(score, &random))
            add(&rows[random.kind][shading], score, number);
        failed = few || is_off(score, &random.scene);
        if (failed)
            printf("  FAILED picture %u (%s): %ld compared, %.2f %% equal, %.3f %% within 1, worst %d at (%d, %d)\n",
                   number, kind_name[random.kind], score->compared, 100 * share(score->equal, score->compared),
                   100 * share(score->within_one, score->compared), score->worst, score->worst_x, score->worst_y);
    }
    if (failed)
        random_scene_print(&random);
    return failed;
}

/* Rows outside their limits. */
static int judge_rows(void)
{
    int failed = 0;

    printf("kind             shading  pictures  equal mean   lowest  lowest within 1  worst  lowest at\n");
    for (int i = 0; i < RANDOM_KINDS * 4; i++) {
        const struct row *row = &rows[i / 4][i % 4];
        if (row->pictures == 0)
            continue;
        printf("%-16s %-8s %8ld %9.2f %% %7.2f %% %13.3f %% %6d %9u\n", kind_name[i / 4], shading_name[i % 4],
               row->pictures, 100 * share(row->equal, row->compared), 100 * row->lowest, 100 * row->lowest_within_one,
               row->worst, row->lowest_at);
        if (row->pictures >= 10 && share(row->equal, row->compared) < accuracy_limits[i % 4].equal) {
            printf("  FAILED too few are equal\n");
            failed++;
        }
    }
    return failed;
}

int main(int argc, char **argv)
{
    static struct random_meshes meshes;
    uint32_t count = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 0;
    uint32_t first = argc > 2 ? (uint32_t)strtoul(argv[2], NULL, 10) : 0;
    double ratio = argc > 3 ? strtod(argv[3], NULL) : 0;
    int failed = 0;

    if (count == 0 || random_meshes_make(&meshes) != 0) {
        fprintf(stderr, "usage: test_accuracy_random PICTURES [FIRST [RATIO]]\n");
        return 2;
    }
    for (uint32_t i = 0; i < count; i++)
        failed += judge(&meshes, first + i, ratio);
    failed += judge_rows();
    random_meshes_free(&meshes);
    printf("%d of %u pictures outside their limits; %ld with an area on a rounding edge\n", failed, count, ties);
    return failed != 0;
}
