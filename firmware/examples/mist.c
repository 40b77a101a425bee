/*
 * mist.c - textures, light and fog: a colonnade that fades into the mist, seen by an eye that sways in front of it. The
 * scene is one OBJ; `sheen bake --groups` made a mesh from each of its materials (host-sim/pictures/mist).
 */
#include "meshes/mist.h"
#include "example.h"
#include "meshes/teapot.h"

#define PARTS (sizeof mist_groups / sizeof mist_groups[0])
#define MIST                                                                                                           \
    {                                                                                                                  \
        226, 204, 182                                                                                                  \
    }

static const struct sheen_light sun = {.to = {-40, 44, 16}};
static const struct sheen_fog fog = {SHEEN_Q24(3.4), SHEEN_Q24(14.5), MIST, &sheen_fog_mixer};
static const struct sheen_material glaze = {.base = {40, 128, 140},
                                            .ambient = SHEEN_Q16(.3),
                                            .diffuse = SHEEN_Q16(.7),
                                            .specular = SHEEN_Q16(.75),
                                            .shine = &sheen_shine_32};

static struct sheen_object objects[PARTS + 1];

/* Parts that are not lit show their colours as they are: the floor's texture contains its light; shadows need none. */
static void make_part(struct sheen_object *object, struct sheen_material *material, size_t i)
{
    const struct sheen_texture *texture = mist_groups[i].texture;
    const int is_lit = i + 1 < PARTS && texture != NULL;

    *material =
        (struct sheen_material){.base = {mist_groups[i].base[0], mist_groups[i].base[1], mist_groups[i].base[2]},
                                .ambient = is_lit ? SHEEN_Q16(.36) : SHEEN_Q16(1),
                                .diffuse = is_lit ? SHEEN_Q16(.85) : 0,
                                .texture = texture};
    *object = (struct sheen_object){.mesh = mist_groups[i].mesh,
                                    .material = material,
                                    .shader = texture != NULL ? &sheen_textured : &sheen_flat,
                                    .lights = &sun,
                                    .light_count = 1};
    if (texture == NULL) { /* shadows on the floor, half transparent */
        object->depth_bias = 16;
        object->stipple = &sheen_stipple;
        object->transparency = 32;
    }
    sheen_pose_identity(&object->pose); /* sheen bake printed the numbers below: a unit's size, and the origin */
    sheen_pose_scale(&object->pose, SHEEN_Q16(10.9910191));
    sheen_pose_translate(&object->pose, 0, SHEEN_Q24(1.95), SHEEN_Q24(-5));
}

int example_init(struct sheen_frame **frame, const struct sheen_target *target)
{
    static uint64_t arena[56320 / 8];
    static struct sheen_material materials[PARTS];
    size_t size = sizeof arena;
    struct sheen_config config = {.target = target,
                                  .band_rows = 8,
                                  .max_vertices = mist_vertices + teapot_vertices,
                                  .max_used = 1100,
                                  .max_triangles = 1200,
                                  .max_draws = PARTS + 1,
                                  .max_clipped = 50,
                                  .clipper = &sheen_clipper};

    for (size_t i = 0; i < PARTS; i++)
        make_part(&objects[i], &materials[i], i);
    objects[PARTS] = (struct sheen_object){
        .mesh = &teapot, .material = &glaze, .shader = &sheen_phong, .lights = &sun, .light_count = 1, .two_sided = 1};
    sheen_pose_rotate(&objects[PARTS].pose, 1, SHEEN_DEGREES(40));
    sheen_pose_scale(&objects[PARTS].pose, SHEEN_Q16(.42));
    sheen_pose_translate(&objects[PARTS].pose, SHEEN_Q24(-.95), SHEEN_Q24(1.01), SHEEN_Q24(-.6));
    return sheen_init(frame, arena, &size, &config);
}

int example_draw(struct sheen_frame *frame, unsigned i)
{
    static const sheen_q24_t middle[3] = {SHEEN_Q24(-.1), SHEEN_Q24(.95), SHEEN_Q24(-7)};
    static const int32_t up[3] = {0, 1, 0};
    struct sheen_view view = {.fov = SHEEN_DEGREES(50),
                              .z_near = SHEEN_Q24(.5),
                              .z_far = SHEEN_Q24(18),
                              .background = MIST,
                              .fog = &fog,
                              .dither = 1};
    const sheen_angle_t at = sheen_degrees(40 + 4 * (int32_t)(i % 90));
    const sheen_q24_t eye[3] = {sheen_sin(at) / 96, SHEEN_Q24(1.6), SHEEN_Q24(2.4) + sheen_cos(at) / 128};
    int error = sheen_pose_look_at(&view.pose, eye, middle, up);

    return error ? error : sheen_render(frame, &view, objects, PARTS + 1);
}
