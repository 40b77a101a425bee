/*
 * test_core_slivers.c - triangles so thin that rounding decides on which side of a plane a corner of what is left lies.
 *
 * Cut by six planes a triangle has at most nine corners in exact arithmetic; of rounded corners only as many as the
 * code makes sure of. Counted is how far the store of each polygon is written.
 */
#include <stdlib.h>
#include <string.h>

#include "test_core_worst.h"

#include "frame/frame.h"
#include "frame_stage.h"

#define WIDTH 64
#define HEIGHT 480
#define SPARE 8 /* corners of room behind the second polygon, so that too many are counted and hurt nobody */

struct sliver {
    int32_t near, far;
    sheen_angle_t fov;
    unsigned height; /* px, of the viewport */
    int16_t position[9];
};

struct bench {
    struct memory_target target;
    struct core_frame frame;
    struct sheen_material material;
    uint8_t *scratch;
    void *own_scratch; /* the frame's */
};

/* A mesh of one triangle whose vertices are eye coordinates in raw steps. */
static struct sheen_mesh mesh_of(const int16_t *position)
{
    static const uint8_t index[3] = {0, 1, 2};

    return (struct sheen_mesh){
        .positions = position, .indices = index, .index_bytes = 1, .vertices = 3, .triangles = 1, .scale = 32768};
}

static void bench_make(struct bench *b)
{
    static const int16_t origin[9];
    struct sheen_mesh mesh = mesh_of(origin);
    struct sheen_view view;
    struct sheen_object draw = {.mesh = &mesh, .material = &b->material, .shader = &sheen_flat, .two_sided = 1};

    memset(b, 0, sizeof *b);
    assert_int_equal(memory_target_init(&b->target, WIDTH, HEIGHT, SHEEN_RGB565_LE), 0);
    const struct sheen_config config = {.target = &b->target.target,
                                        .max_vertices = 3,
                                        .max_triangles = 16,
                                        .max_clipped = 16,
                                        .clipper = &sheen_clipper};
    assert_int_equal(core_frame_make(&b->frame, &config), SHEEN_OK);
    stage_view(&view);
    sheen_pose_identity(&draw.pose);
    assert_int_equal(sheen_begin(b->frame.frame, &view), SHEEN_OK);
    assert_int_equal(sheen_draw(b->frame.frame, &draw), SHEEN_OK); /* nothing of it is listed; its record stays */
    b->own_scratch = b->frame.frame->scratch;
    b->scratch = malloc(sizeof(struct clip_corner) * (2 * MAX_CLIP_CORNERS + SPARE));
    assert_non_null(b->scratch);
    b->frame.frame->scratch = b->scratch;
}

static void bench_free(struct bench *b)
{
    b->frame.frame->scratch = b->own_scratch;
    assert_int_equal(b->target.breaches, 0);
    core_frame_free(&b->frame);
    memory_target_free(&b->target);
    free(b->scratch);
}

/* How many of `room` corners from `store` on were written: their z values never are the pattern's. */
static unsigned written(const uint8_t *store, size_t corner, unsigned room)
{
    while (room > 0) {
        size_t i = 0;
        while (i < corner && store[(room - 1) * corner + i] == 0xa5)
            i++;
        if (i < corner)
            break;
        room--;
    }
    return room;
}

/* The most corners that either polygon had; 0 where the view is refused. */
static unsigned corners_of(struct bench *b, const struct sliver *s)
{
    struct sheen_frame *f = b->frame.frame;
    struct sheen_mesh mesh = mesh_of(s->position);
    struct sheen_view view = {.fov = s->fov, .z_near = s->near, .z_far = s->far};
    size_t corner = sizeof(struct clip_corner);
    struct transform t;
    struct sheen_pose pose;

    if (s->height == 0 ||
        sheen_project_begin(&f->projection, &view, WIDTH, s->height) < 0) /* an empty place in the pool */
        return 0;
    sheen_pose_identity(&pose);
    assert_int_equal(sheen_transform_begin(&t, &f->projection, &mesh, &pose), SHEEN_OK);
    f->draw[0].as.mesh = &mesh;
    f->entries = f->pieces = 0;
    sheen_bin_clear(f);
    for (int k = 0; k < 3; k++) {
        const struct point point = sheen_transform_point(&t, s->position + 3 * k);
        sheen_project(&f->projection, t.screen_shift, &point, &f->vertex[k]);
    }
    memset(b->scratch, 0xa5, corner * (2 * MAX_CLIP_CORNERS + SPARE));
    sheen_clipper.cut(f, f->draw, &t, 0);
    f->entries = f->pieces = 0;
    unsigned first = written(b->scratch, corner, MAX_CLIP_CORNERS);
    unsigned second = written(b->scratch + MAX_CLIP_CORNERS * corner, corner, MAX_CLIP_CORNERS + SPARE);
    return first > second ? first : second;
}

/*
 * Sliver 0..23: on a corner of the guard band between near and far, each corner and each order of the vertices. Once
 * it had ten corners, and the tenth was a worker's memory.
 */
static struct sliver known_sliver(int number)
{
    static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    static const int16_t corner[3][3] = {{59, -60, -11}, {48, -48, -9}, {75, -75, -14}};
    struct sliver s = {.near = 10, .far = 13, .fov = 1632112370u, .height = HEIGHT};

    for (int k = 0; k < 9; k++) {
        int turned = k % 3 < 2 && (number >> (k % 3) & 1) != 0;
        int16_t part = corner[order[number / 4][k / 3]][k % 3];
        s.position[k] = (int16_t)(turned ? -part : part);
    }
    return s;
}

static void test_known_slivers(void **unused)
{
    struct bench b;
    unsigned most = 0;

    (void)unused;
    bench_make(&b);
    for (int i = 0; i < 24; i++) {
        struct sliver s = known_sliver(i);
        unsigned corners = corners_of(&b, &s);
        most = corners > most ? corners : most;
    }
    print_message("           %u corners at most\n", most);
    assert_in_range(most, 4, MAX_CLIP_CORNERS);
    bench_free(&b);
}

/* A coordinate near the guard band's edge at depth m. */
static int16_t at_the_edge(const struct sliver *s, double m, uint32_t *state)
{
    double focal = s->height / 2.0 / tan(s->fov / 4294967296.0 * 3.14159265358979323846);
    double x = (511 + stage_uniform(state, -0.5, 0.5)) * m / focal;

    return (int16_t)lrint(x > 32767 ? 32767 : x);
}

static void random_sliver(struct sliver *s, uint32_t *state)
{
    s->near = 1 + (int32_t)(stage_random(state) % (1u << stage_random(state) % 10)); /* a raw step counts for much */
    int32_t span = 1 + (int32_t)(stage_random(state) % (1u << stage_random(state) % 8));
    s->far = s->near + span;
    s->fov = SHEEN_DEGREES(1) + stage_random(state) % SHEEN_DEGREES(149);
    s->height = 1 + stage_random(state) % HEIGHT;
    for (int k = 0; k < 3; k++) {
        int32_t part = (int32_t)(stage_random(state) % (uint32_t)(1 + span));
        int32_t m = stage_random(state) % 3 == 0   ? s->near - part
                    : stage_random(state) % 2 == 0 ? s->far + part
                                                   : s->near + part;
        m = m < 1 ? 1 : m;
        s->position[3 * k] = at_the_edge(s, m, state);
        s->position[3 * k + 1] = (int16_t)-at_the_edge(s, m, state);
        s->position[3 * k + 2] = (int16_t)-m;
    }
}

static void move_sliver(struct sliver *s, uint32_t *state)
{
    for (uint32_t moves = 1 + stage_random(state) % 4; moves > 0; moves--) {
        int16_t *part = &s->position[stage_random(state) % 9];
        int32_t step = (int32_t)(stage_random(state) >> (17 + stage_random(state) % 15));
        int32_t moved = *part + (stage_random(state) % 2 != 0 ? step : -step);
        *part = (int16_t)(moved > 32767 ? 32767 : moved < -32767 ? -32767 : moved);
    }
    if (stage_random(state) % 4 == 0)
        s->far += (int32_t)(stage_random(state) % 7) - 3;
}

/* A hill climb from those and from others: what has the most corners is changed a little, again and again. */
static void test_no_sliver_has_more(void **unused)
{
    enum {
        POOL = 64
    };
    static struct sliver pool[POOL];
    unsigned score[POOL], most = 0, count = 0;
    uint32_t state = 1;
    struct bench b;

    (void)unused;
    bench_make(&b);
    for (long i = 0; i < 1000000; i++) {
        struct sliver s;
        if (count < 24) {
            s = known_sliver((int)count);
        } else if (count < POOL || stage_random(&state) % 4 == 0) {
            random_sliver(&s, &state);
        } else {
            s = pool[stage_random(&state) % POOL];
            move_sliver(&s, &state);
        }
        unsigned corners = corners_of(&b, &s), place = count < POOL ? count++ : stage_random(&state) % POOL;
        if (count < POOL || corners >= score[place]) {
            pool[place] = s;
            score[place] = corners;
        }
        most = corners > most ? corners : most;
    }
    print_message("           %u corners at most\n", most);
    assert_in_range(most, 6, MAX_CLIP_CORNERS);
    bench_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_known_slivers),
        cmocka_unit_test(test_no_sliver_has_more),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
