/*
 * lecture_distortion.c - a receding plane whose intensities are interpolated linearly on the
 * screen, and perspective-correct by Blinn's method (I/m over 1/m).
 *
 * On the screen t* runs evenly; in space t = t* m1 / ((1 - t*) m2 + t* m1). The intensities
 * differ most where both have the same slope: by dI (sqrt q - 1) / (sqrt q + 1), q = m2/m1.
 */
#include <math.h>

#include "lecture.h"
#include "lecture_scene.h"

#define WIDTH 251 /* px, odd: the middle column runs along the plane's middle */
#define HEIGHT 300
#define NEAR_M 1.4 /* depth of the plane's near end, and of its far end, units */
#define FAR_M 7.0
#define LOW 0.1 /* intensity = LOW + ACROSS u + ALONG v */
#define ACROSS 0.3
#define ALONG 0.55
#define LEVELS 16 /* bands in the pictures, so that lines of equal intensity show */

/* Two quads side by side, so that the plane's middle is an edge. In eye space z is the model's z less the distance. */
static void make_plane(struct sheen_lecture_mesh *m, double distance)
{
    sheen_lecture_mesh_begin(m, 4);
    for (int k = 0; k < 6; k++) {
        double u = k % 3 / 2.0, v = k / 3, normal[3];
        double position[3] = {1.0 * (u - 0.5), v > 0 ? 2.2 : -0.6, distance - (v > 0 ? FAR_M : NEAR_M)};
        sheen_lecture_lean(LOW + ACROSS * u + ALONG * v, 1, 0, normal);
        sheen_lecture_vertex(m, position, normal);
    }
    sheen_lecture_quad(m, 0, 1, 4, 3);
    sheen_lecture_quad(m, 1, 2, 5, 4);
}

static double in_bands(double intensity)
{
    return intensity > 0 ? (floor(intensity * LEVELS) + 0.5) / LEVELS : 0;
}

/* The row, in px from the top, of a point at height y and depth m. */
static double row_of(const struct sheen_lecture_scene *scene, double y, double m)
{
    return HEIGHT / 2.0 * (1 - y / m * scene->distance / scene->reach);
}

struct column {
    double row[HEIGHT], measured[HEIGHT], formula[HEIGHT];
    int count;
    double off; /* largest |measured - formula| */
};

/* The intensities of the middle column, as measured and by the lecture's formula. */
static void take_column(struct column *c, const struct sheen_lecture_scene *scene, const double *picture)
{
    double near_row = row_of(scene, -0.6, NEAR_M), far_row = row_of(scene, 2.2, FAR_M);

    c->count = 0;
    c->off = 0;
    for (int y = HEIGHT - 1; y >= 0; y--) {
        double on_screen = (y + 0.5 - near_row) / (far_row - near_row); /* t* */
        double t = scene->affine ? on_screen : on_screen * NEAR_M / ((1 - on_screen) * FAR_M + on_screen * NEAR_M);
        if (on_screen < 0 || on_screen > 1)
            continue;
        c->row[c->count] = on_screen;
        c->measured[c->count] = picture[y * WIDTH + WIDTH / 2];
        c->formula[c->count] = LOW + ACROSS / 2 + ALONG * t;
        c->off = fmax(c->off, fabs(c->measured[c->count] - c->formula[c->count]));
        c->count++;
    }
}

static int draw_way(struct sheen_page *page, struct sheen_lecture_scene *scene, int affine, struct column *c)
{
    static double picture[WIDTH * HEIGHT];
    enum sheen_ink ink = affine ? SHEEN_INK_WRONG : SHEEN_INK_GOURAUD;
    double left = affine ? 40 : 40 + WIDTH + 24;

    scene->affine = affine;
    int error = sheen_lecture_measure(scene, picture);
    if (error)
        return error;
    take_column(c, scene, picture);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        picture[i] = in_bands(picture[i]);
    sheen_page_intensity(page, left, 108, 1, picture, WIDTH, HEIGHT);
    sheen_page_text(page, left + WIDTH / 2, 434, SHEEN_CENTRE, ink,
                    affine ? "linear on the screen" : "Blinn's way: I/m over 1/m");
    return SHEEN_OK;
}

int sheen_lecture_distortion(struct sheen_page *page)
{
    static struct sheen_lecture_mesh plane;
    static struct column affine, correct;
    struct sheen_lecture_scene scene;
    struct sheen_axes axes = {622, 138, 324, 230, 0, 1, 0.2, 0.85};
    double root = sqrt(FAR_M / NEAR_M), error_found = 0;

    sheen_lecture_scene_default(&scene, &plane.mesh);
    make_plane(&plane, scene.distance);
    scene.ortho = 0;
    scene.width = WIDTH;
    scene.height = HEIGHT;
    scene.reach = 1.74;
    sheen_page_title(page, "Distortion by perspective",
                     "Intensity is linear in space, not on the screen: interpolate I/m and 1/m, m being the depth.");
    sheen_page_caption(page, "A plane that recedes from the eye, with lines of equal intensity. Interpolated on the "
                             "screen they bend at the edge that two faces share; Blinn's way keeps them straight.");
    int error = draw_way(page, &scene, 1, &affine);
    if (!error)
        error = draw_way(page, &scene, 0, &correct);
    if (error)
        return error;
    for (int i = 0; i < affine.count && i < correct.count; i++)
        error_found = fmax(error_found, fabs(affine.measured[i] - correct.measured[i]));
    sheen_page_axes(page, &axes, 0.25, 2, 0.2, 1);
    sheen_page_axis_names(page, &axes, "on the screen, near to far", "intensity along the middle");
    page->heart = (struct sheen_box){580, 114, 966, 416};
    sheen_page_text(page, 640, 222, SHEEN_LEFT, SHEEN_INK_WRONG, "on the screen");
    sheen_page_text(page, 880, 350, SHEEN_RIGHT, SHEEN_INK_GOURAUD, "in space");
    sheen_page_curve(page, &axes, SHEEN_INK_FAINT, 5, affine.row, affine.formula, affine.count);
    sheen_page_curve(page, &axes, SHEEN_INK_FAINT, 5, correct.row, correct.formula, correct.count);
    sheen_page_curve(page, &axes, SHEEN_INK_WRONG, 2, affine.row, affine.measured, affine.count);
    sheen_page_curve(page, &axes, SHEEN_INK_GOURAUD, 2, correct.row, correct.measured, correct.count);
    sheen_page_number(page, 36, 474, SHEEN_INK_TEXT, "depth m from %.1f to %.1f, so q = %.1f", NEAR_M, FAR_M,
                      FAR_M / NEAR_M);
    sheen_page_number(page, 36, 500, SHEEN_INK_WRONG, "linear on the screen is off by up to %.4f", error_found);
    sheen_page_number(page, 36, 526, SHEEN_INK_FLAT, "by the formula, dI (√q - 1) / (√q + 1): %.4f",
                      ALONG * (root - 1) / (root + 1));
    sheen_page_number(page, 36, 552, SHEEN_INK_GOURAUD,
                      "what the core draws lies within %.5f (screen) and %.5f (Blinn) of the grey curves", affine.off,
                      correct.off);
    return SHEEN_OK;
}
