/*
 * lecture_mach.c - Mach bands: a prism of 16 sides that stands for a cylinder, along one scan line.
 *
 * The eye sees bands where intensity jumps (flat) or its slope does (Gouraud); both stand
 * out in the second difference I(x-1) - 2 I(x) + I(x+1).
 */
#include <math.h>
#include <string.h>

#include "lecture.h"
#include "lecture_scene.h"

#define PI 3.14159265358979323846
#define SIDES 16
#define WIDTH 190 /* px */
#define HEIGHT 60
#define RADIUS_PX 90.0

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
        double angle = 2 * PI * (i + 0.5) / SIDES, normal[3] = {sin(angle), 0, cos(angle)};
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

    sheen_lecture_scene_default(scene, m);
    memcpy(scene->light, light, sizeof light);
    scene->width = WIDTH;
    scene->height = HEIGHT;
    scene->reach = HEIGHT / 2 / RADIUS_PX;
    scene->ambient = 0.1;
    scene->diffuse = 0.85;
}

/* The cylinder itself at the centre of column x; the prism ends at radius cos(pi / SIDES) in places. */
static double cylinder(const struct sheen_lecture_scene *scene, int x)
{
    const double *l = scene->light;
    double sine = (x + 0.5 - WIDTH / 2) / RADIUS_PX;
    double cosine = sqrt(fmax(0, 1 - sine * sine)), length = sqrt(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);

    return scene->ambient + scene->diffuse * fmax(0, (l[0] * sine + l[2] * cosine) / length);
}

/* What is compared: 31 degrees off the rim, where a cylinder itself bends, and off the light's edge. */
enum {
    FIRST = 18,
    LAST = WIDTH - 19,
    MIDDLE = 36 /* and what turns less than 41 degrees from the eye: steps and bends are taken there */
};

struct findings {
    double step, bend,
        off; /* largest |first difference|, largest |second difference| in the middle, mean |I - cylinder| */
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

static void draw_plots(struct sheen_page *page, const struct sheen_lecture_scene *scene, int number, double left,
                       const double *row)
{
    double most = number ? 0.01 : 0.4; /* jumps would hide bends */
    double bend[WIDTH], x[WIDTH], truth[WIDTH];
    struct sheen_axes intensity = {left, 210, WIDTH, 140, 0, WIDTH, 0, 1};
    struct sheen_axes second = {left, 394, WIDTH, 140, 0, WIDTH, -most, most};
    const char *name = columns[number].name;
    enum sheen_ink ink = columns[number].ink;
    struct findings f;

    for (int i = 0; i < WIDTH; i++) {
        x[i] = i + 0.5;
        truth[i] = cylinder(scene, i);
    }
    look_at(scene, row, bend, &f);
    sheen_page_axes(page, &intensity, 50, -1, 0.5, number ? -1 : 1);
    sheen_page_curve(page, &intensity, SHEEN_INK_FAINT, 1.2, x + FIRST, truth + FIRST, LAST - FIRST + 1);
    sheen_page_curve(page, &intensity, ink, 1.8, x + FIRST, row + FIRST, LAST - FIRST + 1);
    sheen_page_axes(page, &second, 50, 0, most / 2, number > 1 ? -1 : number ? 3 : 1);
    sheen_page_curve(page, &second, ink, 1.6, x + FIRST, bend + FIRST, LAST - FIRST + 1);
    sheen_page_number(page, left, 576, SHEEN_INK_TEXT, "%s: step %.4f", name, f.step);
    sheen_page_number(page, left, 596, SHEEN_INK_TEXT, "%s: bend %.4f", name, f.bend);
    sheen_page_number(page, left, 616, SHEEN_INK_TEXT, "%s: %.2f/255 off", name, 255 * f.off);
    if (number == 0) {
        sheen_page_axis_names(page, &intensity, NULL, "intensity along the scan line");
        sheen_page_axis_names(page, &second, NULL, "its second difference");
    }
}

static int draw_column(struct sheen_page *page, struct sheen_lecture_scene *scene, int number)
{
    static double picture[WIDTH * HEIGHT];
    double left = number ? 102 + 218 * number : 56; /* the second has a scale of its own */

    scene->shading = columns[number].shading;
    int error = sheen_lecture_measure(scene, picture);
    if (error)
        return error;
    sheen_page_text(page, left + WIDTH / 2, 114, SHEEN_CENTRE, columns[number].ink, "%s", columns[number].name);
    sheen_page_intensity(page, left, 124, 1, picture, WIDTH, HEIGHT);
    draw_plots(page, scene, number, left, picture + HEIGHT / 2 * WIDTH);
    return SHEEN_OK;
}

int sheen_lecture_mach(struct sheen_page *page)
{
    static struct sheen_lecture_mesh prism;
    struct sheen_lecture_scene scene;
    int error = SHEEN_OK;

    make_prism(&prism);
    set_scene(&scene, &prism);
    sheen_page_title(
        page, "Mach bands",
        "Flat shading jumps at the edges, Gouraud bends there, Phong and slerp hardly do. Grey: the cylinder.");
    sheen_page_text(page, 56, 636, SHEEN_LEFT, SHEEN_INK_FLAT,
                    "Step and bend: the largest that face the eye within 41°. Off: from the cylinder, in the mean.");
    for (int number = 0; !error && number < 4; number++)
        error = draw_column(page, &scene, number);
    return error;
}
