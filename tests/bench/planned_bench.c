/*
 * planned_bench.c - the bench's scenes (scenes.h) as frames from which costs are found: all of them in every shading,
 * without and with dither; S1 and S3 also with textures, in fog or with half of their pixels.
 */
#include "planned.h"

enum {
    DITHERED = 1,
    FOGGED = 2,
    STIPPLED = 4,
    MORPHED = 8,
    SMOOTH = 16
};

static const struct {
    const char *name;
    uint8_t shading, texture;
} looks[] = {
    {"-flat", SHEEN_FLAT, BENCH_PLAIN},
    {"-gouraud", SHEEN_GOURAUD, BENCH_PLAIN},
    {"-phong", SHEEN_PHONG, BENCH_PLAIN},
    {"-slerp", SHEEN_SLERP, BENCH_PLAIN},
    {"+unlit", SHEEN_GOURAUD, BENCH_UNLIT},
    {"+lit", SHEEN_GOURAUD, BENCH_LIT},
    {"+glossy", SHEEN_GOURAUD, BENCH_GLOSSY},
    {"+bilinear", SHEEN_GOURAUD, BENCH_BILINEAR},
    {"+matcap", SHEEN_GOURAUD, BENCH_MATCAP},
    {"+matcap-vertex", SHEEN_GOURAUD, BENCH_MATCAP_VERTEX},
    {"+matcap-bilinear", SHEEN_GOURAUD, BENCH_MATCAP_BILINEAR},
};

#define LOOKS (sizeof looks / sizeof looks[0])

/* The extras of each scene's frames, of S1, S2, S3 and S5; the last ones only with Gouraud shading. */
static const uint8_t more[BENCH_SCENES][6] = {{0, DITHERED, FOGGED | DITHERED, STIPPLED | DITHERED, MORPHED, SMOOTH},
                                              {0, DITHERED},
                                              {0, DITHERED, FOGGED, STIPPLED | DITHERED},
                                              {0, DITHERED}};
static const uint8_t most[BENCH_SCENES] = {6, 2, 4, 2};

/* 1 if the scenes include this frame. */
static int is_there(unsigned scene, unsigned look, unsigned with)
{
    if (looks[look].texture != BENCH_PLAIN && scene % 2 != 0)
        return 0;
    return with < MORPHED || (looks[look].texture == BENCH_PLAIN && looks[look].shading == SHEEN_GOURAUD);
}

static char *put_text(char *to, const char *text)
{
    while (*text != '\0')
        *to++ = *text++;
    *to = '\0';
    return to;
}

static void make(struct bench *bench, const struct bench_scene *scene, unsigned look, unsigned with, char name[40])
{
    static const char *const words[] = {"-dithered", "+fogged", "+stippled", "+morphed", "+smooth"};

    bench_config(bench, scene, (enum sheen_shading)looks[look].shading, 16);
    bench->texture = looks[look].texture;
    bench->dither = (with & DITHERED) != 0;
    bench->fogged = (with & FOGGED) != 0;
    bench->transparency = (with & STIPPLED) != 0 ? 32 : 0;
    bench->morphed = (with & MORPHED) != 0;
    bench->edges = (with & SMOOTH) != 0 ? &sheen_edges_smooth : NULL;
    if (bench->morphed)
        bench->config.max_used = scene->mesh.vertices;
    name = put_text(put_text(name, scene->name), looks[look].name);
    for (unsigned bit = 0; bit < sizeof words / sizeof words[0]; bit++)
        if (with >> bit & 1u)
            name = put_text(name, words[bit]);
}

int planned_bench(struct bench *bench, unsigned i, char name[40])
{
    for (unsigned scene = 0; scene < BENCH_SCENES; scene++)
        for (unsigned look = 0; look < LOOKS; look++)
            for (unsigned k = 0; k < most[scene]; k++)
                if (is_there(scene, look, more[scene][k]) && i-- == 0) {
                    make(bench, &bench_scenes[scene], look, more[scene][k], name);
                    return 1;
                }
    return 0;
}
