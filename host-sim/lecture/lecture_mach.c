/*
 * lecture_mach.c - Mach bands: a prism of 16 sides that stands for a cylinder, along one scan line.
 *
 * The eye sees bands where the intensity jumps (flat) or where its slope jumps (Gouraud).
 * Both are peaks of the second difference I(x-1) - 2 I(x) + I(x+1).
 */
#include <math.h>
#include <string.h>

#include "lecture.h"
#include "lecture_scene.h"

#define SIDES 16
#define WIDTH 320 /* px */
#define LEFT 116  /* place of the strips on the page */
#define HEIGHT 60
#define RADIUS_PX 151.0

static const struct {
    const char *name;
    int shading;
    enum sheen_ink ink;
} columns[4] = {{"flat", SHEEN_FLAT, SHEEN_INK_FLAT},
                {"Gouraud", SHEEN_GOURAUD, SHEEN_INK_GOURAUD},
                {"Phong", SHEEN_PHONG, SHEEN_INK_PHONG},
                {"slerp", SHEEN_SLERP, SHEEN_INK_SLERP}};

static void make_prism(struct sheen_lecture_mesh *m)
{
    sheen_lecture_mesh_begin(m, 2);
    for (int i = 0; i < SIDES; i++) {
        double angle = 2 * M_PI * (i + 0.5) / SIDES, normal[3] = {sin(angle), 0, cos(angle)};
        double foot[3] = {normal[0], -0.5, normal[2]}, head[3] = {normal[0], 0.5, normal[2]};
        sheen_lecture_vertex(m, foot, normal);
        sheen_lecture_vertex(m, head, normal);
    }
    for (unsigned i = 0; i < SIDES; i++) {
        unsigned next = (i + 1) % SIDES;
        sheen_lecture_quad(m, 2 * i, 2 * next, 2 * next + 1, 2 * i + 1);
    }
}

static void set_scene(struct sheen_lecture_scene *scene, const struct sheen_lecture_mesh *m)
{
    static const double light[3] = {-0.3, 0, 0.9};

    sheen_lecture_scene_default(scene, &m->mesh);
    memcpy(scene->light, light, sizeof light);
    scene->width = WIDTH;
    scene->height = HEIGHT;
    scene->reach = HEIGHT / 2 / RADIUS_PX;
    scene->ambient = 0.1;
    scene->diffuse = 0.85;
}

/* Intensity of a true cylinder at the centre of column x. In places the prism's radius is only cos(pi / SIDES). */
static double cylinder(const struct sheen_lecture_scene *scene, int x)
{
    const double *l = scene->light;
    double sine = (x + 0.5 - WIDTH / 2) / RADIUS_PX;
    double cosine = sqrt(fmax(0, 1 - sine * sine)), length = sqrt(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);

    return scene->ambient + scene->diffuse * fmax(0, (l[0] * sine + l[2] * cosine) / length);
}

/* The columns compared: 31 degrees off the rim, where a cylinder's own intensity bends, and off the terminator. */
enum {
    FIRST = 30,
    LAST = WIDTH - 31,
    MIDDLE = 61 /* step and bend: MIDDLE..WIDTH - 1 - MIDDLE, less than 41 degrees from the eye */
};

struct findings {
    double step, bend; /* largest |first difference| and |second difference| in the middle */
    double off;        /* mean |I - cylinder| */
};

static void look_at(const struct sheen_lecture_scene *scene, const double *row, double *bend, struct findings *f)
{
    *f = (struct findings){0, 0, 0};
    for (int x = FIRST; x <= LAST; x++) {
        bend[x] = row[x - 1] - 2 * row[x] + row[x + 1];
        if (x >= MIDDLE && x < WIDTH - MIDDLE) {
            f->step = fmax(f->step, fabs(row[x] - row[x - 1]));
            f->bend = fmax(f->bend, fabs(bend[x]));
        }
        f->off += fabs(row[x] - cylinder(scene, x)) / (LAST - FIRST + 1);
    }
}

/* One shading's strip, and the line of what was found along it. */
static void draw_strip(struct sheen_page *page, int number, const double *picture, const struct findings *f)
{
    double y = 112 + (HEIGHT + 16) * number;
    enum sheen_ink ink = columns[number].ink;

    sheen_page_text(page, LEFT - 16, y + 26, SHEEN_RIGHT, ink, "%s", columns[number].name);
    sheen_page_intensity(page, LEFT, y, 1, picture, WIDTH, HEIGHT);
    sheen_page_number(page, 36, 452 + 26 * number, ink, "%s: step %.4f, bend %.4f, off by %.2f/255",
                      columns[number].name, f->step, f->bend, 255 * f->off);
}

/* Adds a shading's row to both plots. The second one clips the curve of flat shading. */
static int draw_shading(struct sheen_page *page, struct sheen_lecture_scene *scene, int number,
                        const struct sheen_axes plots[2])
{
    static double picture[WIDTH * HEIGHT];
    double bend[WIDTH], x[WIDTH];
    struct findings f;

    scene->shading = columns[number].shading;
    int error = sheen_lecture_measure(scene, picture);
    if (error)
        return error;
    const double *row = picture + HEIGHT / 2 * WIDTH;
    for (int i = 0; i < WIDTH; i++)
        x[i] = i + 0.5;
    look_at(scene, row, bend, &f);
    draw_strip(page, number, picture, &f);
    sheen_page_curve(page, &plots[0], columns[number].ink, 1.6, x + FIRST, row + FIRST, LAST - FIRST + 1);
    sheen_page_curve(page, &plots[1], columns[number].ink, 1.6, x + FIRST, bend + FIRST, LAST - FIRST + 1);
    return SHEEN_OK;
}

int sheen_lecture_mach(struct sheen_page *page)
{
    static struct sheen_lecture_mesh prism;
    const struct sheen_axes plots[2] = {{552, 128, 410, 190, 0, WIDTH, 0.2, 1},
                                        {552, 366, 410, 140, 0, WIDTH, -0.012, 0.004}};
    struct sheen_lecture_scene scene;
    double x[WIDTH], truth[WIDTH];
    int error = SHEEN_OK;

    make_prism(&prism);
    set_scene(&scene, &prism);
    sheen_page_title(page, "Mach bands", "Where intensity jumps at the edges of polygons the eye sees bands.");
    sheen_page_caption(page, "A prism of 16 sides that stands for a cylinder (grey). Flat shading steps at the edges, "
                             "Gouraud still bends there, and eyes see both; Phong and slerp hardly do either.");
    page->heart = (struct sheen_box){30, 104, 440, 408};
    sheen_page_axes(page, &plots[0], 40, -1, 0.2, 1);
    sheen_page_axis_names(page, &plots[0], NULL, "intensity along a row");
    sheen_page_axes(page, &plots[1], 40, 0, 0.004, 3);
    sheen_page_axis_names(page, &plots[1], "px along the row", "its bend: I(x - 1) - 2 I(x) + I(x + 1); flat runs off");
    sheen_page_text(page, 36, 566, SHEEN_LEFT, SHEEN_INK_FLAT,
                    "The largest step and bend less than 41° off the eye; off in the mean.");
    for (int i = 0; i < WIDTH; i++) {
        x[i] = i + 0.5;
        truth[i] = cylinder(&scene, i);
    }
    sheen_page_curve(page, &plots[0], SHEEN_INK_FAINT, 4, x + FIRST, truth + FIRST, LAST - FIRST + 1);
    for (int number = 0; !error && number < 4; number++)
        error = draw_shading(page, &scene, number, plots);
    return error;
}
