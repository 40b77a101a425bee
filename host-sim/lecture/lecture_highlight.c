/*
 * lecture_highlight.c - the highlight by Gouraud against Phong, on a ball of 12 x 8 faces.
 *
 * Gouraud shading lights only the corners: it misses a highlight between them, smears one
 * on a corner over all faces around it, and so the highlight flickers as the ball turns.
 */
#include <math.h>
#include <string.h>

#include "lecture.h"
#include "lecture_scene.h"

#define AROUND 12
#define RINGS 8
#define SIZE 185 /* px */
#define LEFT 36  /* place of the pictures on the page, px */
#define TOP 112
#define APART 20
#define TURNS 41    /* samples while the ball turns by two faces */
#define BRIGHT 0.67 /* a pixel above this is part of the highlight: ambient + diffuse alone stay below */

static void make_ball(struct sheen_lecture_mesh *m)
{
    sheen_lecture_mesh_begin(m, 2);
    for (int i = 0; i < (RINGS + 1) * AROUND; i++) {
        double down = M_PI * (i / AROUND) / RINGS, turn = 2 * M_PI * (i % AROUND) / AROUND;
        double normal[3] = {sin(down) * sin(turn), cos(down), sin(down) * cos(turn)};
        sheen_lecture_vertex(m, normal, normal);
    }
    for (unsigned i = 0; i < RINGS * AROUND; i++) {
        unsigned next = i - i % AROUND + (i + 1) % AROUND;
        if (i >= AROUND) /* the quads at the poles are triangles */
            sheen_lecture_triangle(m, i, i + AROUND, next);
        if (i < (RINGS - 1) * AROUND)
            sheen_lecture_triangle(m, next, i + AROUND, next + AROUND);
    }
}

static void set_scene(struct sheen_lecture_scene *scene, const struct sheen_lecture_mesh *m)
{
    static const double light[3] = {-0.55, 0.62, 0.75};
    static const uint8_t base[3] = {0x88, 0xbc, 0xff};

    sheen_lecture_scene_default(scene, &m->mesh);
    memcpy(scene->light, light, sizeof light);
    memcpy(scene->base, base, sizeof base);
    scene->width = scene->height = SIZE;
    scene->reach = 1.08;
    scene->yaw = 360.0 / AROUND / 2;
    scene->ambient = 0.15;
    scene->diffuse = 0.5;
    scene->specular = 0.35;
    scene->shininess = 40;
}

/* The direction halfway between light and eye: the normal at the highlight and, on a unit ball, its place. */
static void halfway(const struct sheen_lecture_scene *scene, double h[3])
{
    const double *l = scene->light;
    double length = sqrt(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);

    h[0] = l[0] / length;
    h[1] = l[1] / length;
    h[2] = l[2] / length + 1;
    length = sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
    for (int k = 0; k < 3; k++)
        h[k] /= length;
}

/* The intensity of a true ball at the centre of pixel (x, y); 0 outside the ball. */
static double ball(const struct sheen_lecture_scene *scene, int x, int y)
{
    double unit = 2 * scene->reach / SIZE, nx = (x + 0.5 - SIZE / 2.0) * unit, ny = (SIZE / 2.0 - y - 0.5) * unit;
    const double *l = scene->light;

    if (nx * nx + ny * ny >= 1)
        return 0;
    double nz = sqrt(1 - nx * nx - ny * ny), length = sqrt(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);
    double ln = (l[0] * nx + l[1] * ny + l[2] * nz) / length, rv = 2 * ln * nz - l[2] / length;
    if (ln <= 0)
        return scene->ambient;
    return scene->ambient + scene->diffuse * ln +
           scene->specular * pow(fmax(0, rv), scene->shininess) * fmin(1, 8 * ln);
}

/* The brightest pixel belongs to the highlight, because nothing else is nearly as bright. */
static double brightest(const double *intensity, int count)
{
    double most = 0;

    for (int i = 0; i < count; i++)
        most = fmax(most, intensity[i]);
    return most;
}

static int bright_pixels(const double *row)
{
    int count = 0;

    for (int x = 0; x < SIZE; x++)
        count += row[x] > BRIGHT;
    return count;
}

static int draw_scan_line(struct sheen_page *page, struct sheen_lecture_scene *scene)
{
    static double gouraud[SIZE * SIZE], phong[SIZE * SIZE], truth[SIZE], x[SIZE];
    struct sheen_axes axes = {552, 128, 410, 170, 0, SIZE, 0, 1};
    double h[3];

    halfway(scene, h);
    int y = (int)((1 - h[1] / scene->reach) * SIZE / 2), error;
    scene->shading = SHEEN_GOURAUD;
    error = sheen_lecture_measure(scene, gouraud);
    scene->shading = SHEEN_PHONG;
    if (!error)
        error = sheen_lecture_measure(scene, phong);
    if (error)
        return error;
    for (int i = 0; i < SIZE; i++) {
        x[i] = i + 0.5;
        truth[i] = ball(scene, i, y);
    }
    sheen_page_axes(page, &axes, 40, 0, 0.25, 2);
    sheen_page_axis_names(page, &axes, "px along the marked scan line", "intensity");
    sheen_page_curve(page, &axes, SHEEN_INK_FAINT, 3.5, x, truth, SIZE);
    sheen_page_curve(page, &axes, SHEEN_INK_GOURAUD, 1.8, x, gouraud + y * SIZE, SIZE);
    sheen_page_curve(page, &axes, SHEEN_INK_PHONG, 1.8, x, phong + y * SIZE, SIZE);
    sheen_page_line(page, SHEEN_INK_WRONG, 1, LEFT, TOP + y + 0.5, LEFT + 2 * SIZE + APART, TOP + y + 0.5);
    sheen_page_number(page, 36, 386, SHEEN_INK_GOURAUD, "Gouraud: brightest %.3f, on the line %d px above %.2f",
                      brightest(gouraud, SIZE * SIZE), bright_pixels(gouraud + y * SIZE), BRIGHT);
    sheen_page_number(page, 36, 412, SHEEN_INK_PHONG, "Phong: brightest %.3f, %d px above",
                      brightest(phong, SIZE * SIZE), bright_pixels(phong + y * SIZE));
    sheen_page_number(page, 36, 438, SHEEN_INK_FLAT, "the ball itself: brightest %.3f, %d px above",
                      brightest(truth, SIZE), bright_pixels(truth));
    return SHEEN_OK;
}

static int draw_turning(struct sheen_page *page, struct sheen_lecture_scene scene)
{
    static double picture[SIZE * SIZE];
    struct sheen_axes axes = {552, 386, 410, 140, 0, 60, 0.25, 1};
    static const enum sheen_ink ink[2] = {SHEEN_INK_GOURAUD, SHEEN_INK_PHONG};
    static const char *const name[2] = {"Gouraud", "Phong"};

    scene.width = scene.height = 81; /* px: enough to find the brightest pixel */
    sheen_page_axes(page, &axes, 15, 0, 0.25, 2);
    sheen_page_axis_names(page, &axes, "degrees that the ball has turned", "its brightest pixel");
    for (int k = 0; k < 2; k++) {
        double degrees[TURNS], most[TURNS], low = 1, high = 0;
        scene.shading = k ? SHEEN_PHONG : SHEEN_GOURAUD;
        for (int i = 0; i < TURNS; i++) {
            degrees[i] = 60.0 * i / (TURNS - 1);
            scene.yaw = degrees[i];
            int error = sheen_lecture_measure(&scene, picture);
            if (error)
                return error;
            most[i] = brightest(picture, scene.width * scene.height);
            low = fmin(low, most[i]);
            high = fmax(high, most[i]);
        }
        sheen_page_curve(page, &axes, ink[k], 2, degrees, most, TURNS);
        sheen_page_number(page, 36, 490 + 26 * k, ink[k], "%s, turning: brightest from %.3f to %.3f", name[k], low,
                          high);
    }
    return SHEEN_OK;
}

int sheen_lecture_highlight(struct sheen_page *page)
{
    static struct sheen_lecture_mesh mesh;
    static uint8_t rgb[SIZE * SIZE * 3];
    struct sheen_lecture_scene scene;
    int error = SHEEN_OK;

    make_ball(&mesh);
    set_scene(&scene, &mesh);
    sheen_page_title(page, "Highlights", "Gouraud's intensities smooth highlights out; Phong keeps them tight.");
    sheen_page_caption(page, "A ball of 96 faces. Gouraud lights only the corners: what falls between them is missed, "
                             "so the highlight is smeared and flickers as the ball turns. Phong finds it every time.");
    page->heart = (struct sheen_box){30, 106, 432, 336};
    for (int k = 0; !error && k < 2; k++) {
        scene.shading = k ? SHEEN_PHONG : SHEEN_GOURAUD;
        error = sheen_lecture_picture(&scene, rgb);
        sheen_page_picture(page, LEFT + k * (SIZE + APART), TOP, 1, rgb, SIZE, SIZE);
        sheen_page_text(page, LEFT + k * (SIZE + APART) + SIZE / 2, TOP + SIZE + 26, SHEEN_CENTRE,
                        k ? SHEEN_INK_PHONG : SHEEN_INK_GOURAUD, k ? "Phong, n = 40" : "Gouraud, n = 40");
    }
    if (!error)
        error = draw_scan_line(page, &scene);
    return error ? error : draw_turning(page, scene);
}
