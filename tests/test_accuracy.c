/*
 * test_accuracy.c - how close the integers come to the picture in double precision.
 *
 * Every picture is judged by itself; a line sums up one mesh, view and shading:
 * both sizes, perspective and affine, shininess 8, 32 and 128. With an argument
 * it writes each picture that fails as PPM files with that prefix: the core's,
 * the reference's, and where they differ.
 */
#include <stdio.h>
#include <string.h>

#include "accuracy.h"
#include "loaded_mesh.h"

static const char *const shading_name[] = {"flat", "gouraud", "phong", "slerp"};
static const char *prefix;

/* The lowest shares and the worst pixel of a line's pictures. */
struct line {
    double compared, equal, mean, within_one, highlight;
    int worst, pictures, failed;
    char lowest[64]; /* which picture had the lowest equal share */
};

static void write_ppm(const char *what, const struct ref_scene *scene, const uint16_t *values)
{
    static int number;
    char name[256];

    snprintf(name, sizeof name, "%s%03d-%s.ppm", prefix, number++ / 3, what);
    FILE *file = fopen(name, "wb");
    if (!file) {
        perror(name);
        return;
    }
    fprintf(file, "P6\n%d %d\n255\n", scene->width, scene->height);
    for (int i = 0; i < scene->width * scene->height; i++) {
        int r = values[i] >> 11, g = values[i] >> 5 & 63, b = values[i] & 31;
        fputc(r << 3 | r >> 2, file);
        fputc(g << 2 | g >> 4, file);
        fputc(b << 3 | b >> 2, file);
    }
    fclose(file);
}

static void write_difference(const struct ref_scene *scene, uint16_t *values)
{
    struct ref_picture picture;

    if (!prefix || ref_render(&picture, scene) != 0)
        return;
    write_ppm("core", scene, values);
    for (int i = 0; i < scene->width * scene->height; i++) {
        uint16_t core = values[i];
        values[i] = picture.pixels[i].value;
        picture.pixels[i].value = core == values[i] ? 0 : 0xffff;
    }
    write_ppm("reference", scene, values);
    for (int i = 0; i < scene->width * scene->height; i++)
        values[i] = picture.pixels[i].value;
    write_ppm("differing", scene, values);
    ref_picture_free(&picture);
}

static double share(long part, long whole)
{
    return whole > 0 ? (double)part / (double)whole : 1;
}

static void add(struct line *line, const struct ref_score *score, const struct ref_scene *scene)
{
    double equal = share(score->equal, score->compared), highlight = share(score->highlight_equal, score->highlight);

    if (line->pictures == 0 || equal < line->equal) {
        line->equal = equal;
        snprintf(line->lowest, sizeof line->lowest, "%dx%d %s n %.0f", scene->width, scene->height,
                 scene->affine ? "affine" : "correct", scene->shininess);
    }
    line->mean += equal;
    line->pictures++;
    line->compared = line->compared < share(score->compared, score->covered) ? line->compared
                                                                             : share(score->compared, score->covered);
    line->within_one = line->within_one < share(score->within_one, score->compared)
                           ? line->within_one
                           : share(score->within_one, score->compared);
    line->highlight = line->highlight < highlight ? line->highlight : highlight;
    line->worst = line->worst > score->worst ? line->worst : score->worst;
}

/* One picture: 0 where it keeps the limits, 1 where not, negative where it could not be drawn. */
static int judge(struct line *line, const struct ref_scene *scene, const struct sheen_mesh *mesh)
{
    static uint16_t values[640 * 480];
    struct ref_score score;
    int status = accuracy_score(&score, scene, mesh, values);

    if (status < 0) {
        printf("  not drawn: %s\n", sheen_strerror(status));
        return status;
    }
    add(line, &score, scene);
    if (accuracy_kept(&score, scene->shading))
        return 0;
    printf("  FAILED %dx%d %s n %.0f: %ld covered, %ld compared, %ld equal, %ld within one step, worst %d at (%d, %d) "
           "of triangle %u\n",
           scene->width, scene->height, scene->affine ? "affine" : "correct", scene->shininess, score.covered,
           score.compared, score.equal, score.within_one, score.worst, score.worst_x, score.worst_y, score.cause);
    write_difference(scene, values);
    return 1;
}

/* What a line varies besides. */
enum variant {
    PLAIN,
    LIGHTS,
    ORTHO
};
static const char *const variant_name[] = {"", "lights", "ortho"};

/* A line of the table: 12 pictures. */
static int judge_line(const struct accuracy_mesh *mesh, int view, enum ref_shading shading, enum variant variant)
{
    static const double shininess[3] = {8, 32, 128};
    struct line line = {.compared = 1, .within_one = 1, .highlight = 1};

    for (int i = 0; i < 12; i++) {
        struct ref_scene scene;
        accuracy_view(&scene, &mesh->reference, view);
        scene.shading = shading;
        scene.shininess = shininess[i % 3];
        scene.affine = i / 3 % 2;
        scene.width = i / 6 ? 240 : 320;
        if (variant == LIGHTS)
            accuracy_more_lights(&scene);
        if (variant == ORTHO)
            accuracy_ortho(&scene);
        int status = judge(&line, &scene, mesh->mesh);
        if (status < 0)
            return status;
        line.failed += status;
    }
    printf("%-15s %d %-6s %-8s %6.1f %% %7.2f %% %7.2f %% %8.3f %% %3d %8.2f %%  %s\n", mesh->name, view,
           variant_name[variant], shading_name[shading], 100 * line.compared, 100 * line.mean / line.pictures,
           100 * line.equal, 100 * line.within_one, line.worst, 100 * line.highlight, line.lowest);
    return line.failed;
}

static int judge_mesh(const struct accuracy_mesh *mesh, enum ref_shading shading)
{
    int failed = 0;

    for (int view = 0; view < ACCURACY_VIEWS; view++)
        failed += judge_line(mesh, view, shading, PLAIN) != 0;
    failed += judge_line(mesh, 1, shading, LIGHTS) != 0;
    failed += judge_line(mesh, 0, shading, ORTHO) != 0;
    return failed;
}

/* The command's own way: its reader, normals, splitting and numbers against the reference's. Flat: too fine. */
static int judge_loaded(const char *name)
{
    struct accuracy_mesh mesh;
    struct loaded_mesh loaded;
    int failed = 0;

    if (loaded_mesh_make(&loaded, name) != 0)
        return 1;
    mesh = (struct accuracy_mesh){.name = loaded.name, .reference = loaded.reference, .mesh = &loaded.quantised.mesh};
    for (int shading = REF_GOURAUD; shading <= REF_SLERP; shading++)
        failed += judge_mesh(&mesh, (enum ref_shading)shading);
    loaded_mesh_free(&loaded);
    return failed;
}

static int judge_shape(int index)
{
    int failed = 0;

    for (int shading = REF_FLAT; shading <= REF_SLERP; shading++) {
        struct accuracy_mesh mesh;
        if (accuracy_mesh_make(&mesh, index, shading == REF_FLAT) != 0) {
            fprintf(stderr, "test_accuracy: shape %d could not be made\n", index);
            return 1;
        }
        failed += judge_mesh(&mesh, (enum ref_shading)shading);
        accuracy_mesh_free(&mesh);
    }
    return failed;
}

int main(int argc, char **argv)
{
    static const char *const loaded[] = {"builtin:teapot", "builtin:sphere", "builtin:torus", "data/egg.obj"};
    int failed = 0;

    prefix = argc > 1 ? argv[1] : NULL;
    printf("mesh            view     shading compared  equal mean   lowest   within 1  worst  in highl.  lowest at\n");
    for (size_t i = 0; i < sizeof loaded / sizeof *loaded; i++)
        failed += judge_loaded(loaded[i]);
    for (int index = 0; index < ACCURACY_SHAPES; index++)
        failed += judge_shape(index);
    printf("%d lines outside their limits\n", failed);
    return failed != 0;
}
