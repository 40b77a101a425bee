/*
 * lecture_terms.c - the three terms of light, each drawn alone, and what the exponent n does to the highlight.
 */
#include <math.h>
#include <string.h>

#include "lecture.h"
#include "lecture_scene.h"
#include "pixel/pixel.h"
#include "quantise.h"

#define WIDTH 184 /* px */
#define SMALL 166 /* width of the pictures with different n, px */
#define HEIGHT 118
#define PLOTTED 241

static const struct {
    const char *name;
    double ambient, diffuse, specular;
} terms[4] = {
    {"ambient", 0.3, 0, 0}, {"+ diffuse", 0, 0.6, 0}, {"+ specular", 0, 0, 0.5}, {"= all three", 0.3, 0.6, 0.5}};

static void set_scene(struct sheen_lecture_scene *scene, const struct sheen_mesh *teapot)
{
    static const double light[3] = {0.4, 0.6, 1};
    static const uint8_t base[3] = {0xff, 0x7f, 0x50};

    sheen_lecture_scene_default(scene, teapot);
    memcpy(scene->light, light, sizeof light);
    memcpy(scene->base, base, sizeof base);
    scene->width = WIDTH;
    scene->height = HEIGHT;
    scene->distance = 2.3;
    scene->reach = 0.7;
    scene->ortho = 0;
    scene->pitch = 20;
    scene->yaw = 25;
    scene->two_sided = 1;
    scene->shading = SHEEN_PHONG;
    scene->shininess = 32;
}

static int draw_terms(struct sheen_page *page, struct sheen_lecture_scene scene)
{
    static double part[4][WIDTH * HEIGHT];
    static uint8_t rgb[WIDTH * HEIGHT * 3];
    double off = 0;

    for (int k = 0; k < 4; k++) {
        double x = 36 + (WIDTH + 14) * (k % 2), y = 104 + (HEIGHT + 34) * (k / 2);
        scene.ambient = terms[k].ambient;
        scene.diffuse = terms[k].diffuse;
        scene.specular = terms[k].specular;
        int error = sheen_lecture_picture(&scene, rgb);
        if (!error)
            error = sheen_lecture_measure(&scene, part[k]);
        if (error)
            return error;
        sheen_page_picture(page, x, y, 1, rgb, WIDTH, HEIGHT);
        sheen_page_text(page, x + WIDTH / 2, y + HEIGHT + 20, SHEEN_CENTRE, SHEEN_INK_TEXT, "%s", terms[k].name);
    }
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double sum = part[0][i] + part[1][i] + part[2][i];
        off = fmax(off, fabs(fmin(sum, 1) - part[3][i]));
    }
    page->heart = (struct sheen_box){30, 98, 424, 404};
    sheen_page_number(page, 36, 480, SHEEN_INK_TEXT, "the three added up, against all three at once: off by %.2f/255",
                      255 * off);
    return SHEEN_OK;
}

static int draw_exponents(struct sheen_page *page, struct sheen_lecture_scene scene)
{
    static const int n[3] = {4, 16, 64};
    static uint8_t rgb[WIDTH * HEIGHT * 3];

    scene.ambient = terms[3].ambient;
    scene.diffuse = terms[3].diffuse;
    scene.specular = terms[3].specular;
    scene.width = SMALL;
    scene.reach = 0.77;
    for (int k = 0; k < 3; k++) {
        double x = 456 + (SMALL + 4) * k;
        scene.shininess = n[k];
        int error = sheen_lecture_picture(&scene, rgb);
        if (error)
            return error;
        sheen_page_picture(page, x, 104, 1, rgb, SMALL, HEIGHT);
        sheen_page_text(page, x + SMALL / 2, 104 + HEIGHT + 20, SHEEN_CENTRE, SHEEN_INK_TEXT, "n = %d", n[k]);
    }
    return SHEEN_OK;
}

/* Plots s^n, looked up as the core's rows do, against the angle whose cosine is s. */
static int draw_powers(struct sheen_page *page)
{
    static const int n[3] = {4, 16, 64};
    static const double label[3] = {50.5, 25.4, 13.4};
    struct sheen_axes axes = {506, 292, 456, 120, 0, 60, 0, 1};
    double angle[PLOTTED], table[PLOTTED], exact[PLOTTED], off = 0;

    sheen_page_axes(page, &axes, 10, 0, 0.5, 1);
    sheen_page_axis_names(page, &axes, "degrees between R and V", "(R·V)ⁿ, looked up in the core's tables");
    for (int k = 0; k < 3; k++) {
        struct sheen_shine shine;
        int error = sheen_shine_make(&shine, (unsigned)n[k]);
        if (error)
            return error;
        struct power power = power_of(&shine);
        for (int i = 0; i < PLOTTED; i++) {
            angle[i] = 60.0 * i / (PLOTTED - 1);
            double s = cos(angle[i] * M_PI / 180);
            table[i] = power_at(power, (int32_t)lround((1 - s) * (1 << 29))) / 32768.0;
            exact[i] = pow(s, n[k]);
            off = fmax(off, fabs(table[i] - exact[i]));
        }
        sheen_page_curve(page, &axes, SHEEN_INK_FAINT, 5, angle, exact, PLOTTED);
        sheen_page_curve(page, &axes, SHEEN_INK_PHONG, 1.8, angle, table, PLOTTED);
        sheen_page_text(page, axes.x + axes.width * label[k] / 60 + 4, 386, SHEEN_LEFT, SHEEN_INK_PHONG, "n = %d",
                        n[k]);
    }
    sheen_page_number(page, 36, 506, SHEEN_INK_PHONG, "the tables of n = 4, 16, 64 are off by at most %.5f", off);
    return SHEEN_OK;
}

static int load_teapot(struct sheen_quantised *teapot)
{
    struct sheen_host_options how = {.average = 1};
    struct sheen_problem problem;
    struct sheen_host_mesh host;
    int error = sheen_host_mesh_load(&host, "builtin:teapot", &how, &problem);

    if (error)
        return error;
    error = sheen_quantise(teapot, &host, SHEEN_ALL_PARTS);
    sheen_host_mesh_free(&host);
    return error;
}

int sheen_lecture_terms(struct sheen_page *page)
{
    struct sheen_lecture_scene scene;
    struct sheen_quantised teapot;
    int error = load_teapot(&teapot);

    if (error)
        return error;
    sheen_page_title(page, "Three terms of light",
                     "I = Ia ka + Ip kd (L·N) + Ip ks (R·V)ⁿ: ambient, diffuse, specular.");
    sheen_page_caption(page,
                       "Ambient light is the same everywhere, diffuse light falls with the angle to the lamp, and "
                       "the highlight lies where the lamp is mirrored: the larger n, the smaller and sharper it is.");
    set_scene(&scene, &teapot.mesh);
    error = draw_terms(page, scene);
    if (!error)
        error = draw_exponents(page, scene);
    if (!error)
        error = draw_powers(page);
    sheen_quantised_free(&teapot);
    return error;
}
