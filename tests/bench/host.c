/*
 * host.c - one scene on this machine, for callgrind, which counts inside bench_measured.
 *
 *   bench_host S1 phong 16 [dithered]    runs both frames and prints what was drawn
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

static const char *const shading_name[] = {"flat", "gouraud", "phong", "slerp"};

static int find(const char *name, const char *const *names, int count)
{
    for (int i = 0; i < count; i++) {
        if (strcmp(name, names[i]) == 0)
            return i;
    }
    return -1;
}

static int run(const struct bench_scene *scene, enum sheen_shading shading, int band_rows, int dither)
{
    struct bench bench;
    struct sheen_stats stats;

    bench_config(&bench, scene, shading, band_rows);
    bench.dither = (uint8_t)dither;
    size_t size = sheen_arena_size(&bench.config);
    void *arena = size > 0 ? malloc(size) : NULL;
    if (!arena)
        return SHEEN_ERR_MEMORY;
    int status = bench_begin(&bench, arena, size);
    if (status == SHEEN_OK)
        status = bench_first(&bench);
    if (status == SHEEN_OK)
        status = bench_measured(&bench);
    if (status == SHEEN_OK) {
        sheen_frame_stats(bench.frame, &stats);
        printf("%s %s %d: arena %zu B, tables %zu B, %u triangles, %u drawn, %u set-ups, %u spans\n", scene->name,
               shading_name[shading], band_rows, size, sizeof bench.material, stats.triangles, stats.drawn,
               stats.setups, stats.spans);
    }
    free(arena);
    return status;
}

int main(int argc, char **argv)
{
    const char *names[BENCH_SCENES];
    int dither = argc == 5 && strcmp(argv[4], "dithered") == 0, known = argc == 4 || dither;

    for (int i = 0; i < BENCH_SCENES; i++)
        names[i] = bench_scenes[i].name;
    int scene = known ? find(argv[1], names, BENCH_SCENES) : -1, shading = known ? find(argv[2], shading_name, 4) : -1;
    int rows = known ? atoi(argv[3]) : 0;
    if (scene < 0 || shading < 0 || rows < 1 || rows > BENCH_HEIGHT) {
        fprintf(stderr, "usage: bench_host S1|S2|S3|S5 flat|gouraud|phong|slerp BAND_ROWS [dithered]\n");
        return 2;
    }
    int status = run(&bench_scenes[scene], (enum sheen_shading)shading, rows, dither);
    if (status < 0)
        fprintf(stderr, "bench_host: %s\n", sheen_strerror(status));
    return status < 0;
}
