/*
 * lecture_specular.c - the highlight without a root: R.V = 2 (L.N)(N.V) - L.V. For an interpolated N, L.N and N.V are
 * linear, and their product is divided by D = N.N.
 */
#include <math.h>

#include "lecture.h"
#include "lecture_scene.h"

#define COUNT 320  /* px along the row */
#define ROWS 49    /* odd: the middle one is measured */
#define DEGREES 40 /* between the normals at the row's ends */
#define FROM 18.0  /* direction of the light, degrees left of the eye's */
#define SHININESS 8

static double dot(const double a[2], const double b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

/* A unit vector in the plane that all vectors lie in: v[0] points right, v[1] to the eye. */
static void unit(double degrees, double v[2])
{
    v[0] = sin(degrees * M_PI / 180);
    v[1] = cos(degrees * M_PI / 180);
}

struct ways {
    double root, quotient, neither; /* R.V with N normalised, with the quotient by D, and without either */
};

static struct ways reflected(double t)
{
    double n1[2], n2[2], l[2], v[2], n[2], r[2];

    unit(-DEGREES / 2.0, n1);
    unit(DEGREES / 2.0, n2);
    unit(-FROM, l);
    unit(0, v);
    double ln = (1 - t) * dot(l, n1) + t * dot(l, n2), nv = (1 - t) * dot(v, n1) + t * dot(v, n2);
    for (int k = 0; k < 2; k++)
        n[k] = (1 - t) * n1[k] + t * n2[k];
    double d = dot(n, n), length = sqrt(d);
    for (int k = 0; k < 2; k++)
        n[k] /= length;
    for (int k = 0; k < 2; k++)
        r[k] = 2 * dot(l, n) * n[k] - l[k];
    return (struct ways){dot(r, v), 2 * ln * nv / d - dot(l, v), 2 * ln * nv - dot(l, v)};
}

struct rows {
    double x[COUNT], exact[COUNT], neither[COUNT];
    double apart; /* largest difference between `root` and `quotient` */
};

static void take_rows(struct rows *rows)
{
    rows->apart = 0;
    for (int i = 0; i < COUNT; i++) {
        struct ways w = reflected((i + 0.5) / COUNT);
        rows->x[i] = i + 0.5;
        rows->exact[i] = pow(fmax(w.root, 0), SHININESS);
        rows->neither[i] = pow(fmax(w.neither, 0), SHININESS);
        rows->apart = fmax(rows->apart, fabs(w.root - w.quotient));
    }
}

/* Draws the highlight alone. */
static int measure(int shininess, double *picture)
{
    static struct sheen_lecture_mesh facet;
    struct sheen_lecture_scene scene;

    sheen_lecture_facet(&facet, DEGREES, COUNT, ROWS);
    sheen_lecture_facet_scene(&scene, &facet, COUNT, ROWS, FROM);
    scene.shading = SHEEN_PHONG;
    scene.diffuse = 0;
    scene.specular = 1;
    scene.shininess = shininess;
    return sheen_lecture_measure(&scene, picture);
}

static int draw_strips(struct sheen_page *page)
{
    static const int shininess[3] = {2, SHININESS, 32};
    static double picture[COUNT * ROWS];

    for (int k = 0; k < 3; k++) {
        double y = 254 + 62 * k;
        int error = measure(shininess[k], picture);
        if (error)
            return error;
        for (int i = 0; i < COUNT * ROWS; i++)
            picture[i] = fmax(picture[i], 1e-6); /* not 0, which would show as not drawn */
        sheen_page_intensity(page, 552, y, 1, picture, COUNT, ROWS);
        sheen_page_text(page, 890, y + 30, SHEEN_LEFT, SHEEN_INK_PHONG, "n = %d", shininess[k]);
    }
    return SHEEN_OK;
}

static void draw_formulas(struct sheen_page *page)
{
    sheen_page_text(page, 480, 134, SHEEN_LEFT, SHEEN_INK_FLAT, "reflect, then look:");
    sheen_page_text(page, 640, 134, SHEEN_LEFT, SHEEN_INK_FLAT, "R = 2 (L·N) N - L,  N = N' / √D");
    sheen_page_text(page, 480, 166, SHEEN_LEFT, SHEEN_INK_PHONG, "the same:");
    sheen_page_text(page, 640, 166, SHEEN_LEFT, SHEEN_INK_PHONG, "R·V = 2 (L·N') (N'·V) / D - L·V");
    sheen_page_text(page, 480, 206, SHEEN_LEFT, SHEEN_INK_FLAT,
                    "N' interpolated, so L·N' and N'·V are as easy as Gouraud's.");
}

int sheen_lecture_specular(struct sheen_page *page)
{
    static double picture[COUNT * ROWS];
    static struct rows rows;
    struct sheen_axes axes = {76, 128, 340, 240, 0, COUNT, 0, 1.05};
    const double *row = picture + ROWS / 2 * COUNT;
    double off = 0, dim = 0;

    take_rows(&rows);
    int error = measure(SHININESS, picture);
    for (int i = 0; i < COUNT; i++) {
        off = fmax(off, fabs(row[i] - rows.exact[i]));
        dim = fmax(dim, rows.exact[i] - rows.neither[i]);
    }
    sheen_page_title(page, "A highlight without a root",
                     "R·V needs the square of a normal's length only: a quotient by D, no root.");
    sheen_page_caption(page,
                       "The highlight on a facet whose normals turn by 40°. What the core draws (blue) lies on the "
                       "reflected ray's own (grey); without the quotient the highlight would be lost (red).");
    sheen_page_axes(page, &axes, 80, 0, 0.25, 2);
    sheen_page_axis_names(page, &axes, "px along the row", "highlight (R·V)ⁿ, n = 8");
    sheen_page_curve(page, &axes, SHEEN_INK_FAINT, 5, rows.x, rows.exact, COUNT);
    sheen_page_curve(page, &axes, SHEEN_INK_WRONG, 2, rows.x, rows.neither, COUNT);
    sheen_page_curve(page, &axes, SHEEN_INK_PHONG, 2, rows.x, row, COUNT);
    sheen_page_text(page, 300, 190, SHEEN_LEFT, SHEEN_INK_PHONG, "over D");
    sheen_page_text(page, 150, 300, SHEEN_LEFT, SHEEN_INK_WRONG, "without D");
    page->heart = (struct sheen_box){30, 104, 436, 420};
    draw_formulas(page);
    if (!error)
        error = draw_strips(page);
    sheen_page_number(page, 36, 480, SHEEN_INK_FLAT, "in doubles both formulas agree to %.1g", rows.apart);
    sheen_page_number(page, 36, 506, SHEEN_INK_PHONG, "the core's pixels are off by at most %.2f/255", 255 * off);
    sheen_page_number(page, 36, 532, SHEEN_INK_WRONG, "without the quotient: too dark by up to %.0f/255", 255 * dim);
    return error;
}
