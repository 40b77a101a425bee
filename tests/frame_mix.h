/*
 * frame_mix.h - a few frames of random objects: any shading combined with any options of a draw and of a view.
 */
#ifndef FRAME_MIX_H
#define FRAME_MIX_H

#include "frame_stage.h"

#define MIX_WIDTH 96 /* px, of the target */
#define MIX_HEIGHT 80
#define MIX_FRAMES 3
#define MIX_OBJECTS 3
#define MIX_VERTICES 300 /* of a mesh, at most */
#define MIX_TRIANGLES 400

/* A mesh of the stage with all optional parts of a mesh. */
struct mix_mesh {
    struct sheen_mesh mesh, second; /* second: another frame of it, for morphs */
    int16_t uvs[2 * MIX_VERTICES], positions[3 * MIX_VERTICES], normals[3 * MIX_VERTICES];
    uint8_t colors[3 * MIX_VERTICES], warp[MIX_TRIANGLES];
    struct sheen_triangle_edges edges[MIX_TRIANGLES];
};

/* All that an object points to, except its mesh. */
struct mix_look {
    struct sheen_material material;
    struct sheen_texture texture;
    struct sheen_ramp gamma;
    struct sheen_light lights[SHEEN_MAX_LIGHTS];
    struct sheen_morph morph;
};

/* The contents of one frame, and the rectangle that is marked in it. */
struct mix_frame {
    struct sheen_view view;
    struct sheen_fog fog;
    struct sheen_object object[MIX_OBJECTS];
    unsigned count;
    struct sheen_rect mark; /* empty: none */
    bool invalidated;
};

struct mix {
    struct mix_look look[MIX_OBJECTS];
    unsigned shader[MIX_OBJECTS];
    unsigned count; /* of objects; some are missing in some frames */
    struct mix_frame frame[MIX_FRAMES];
};

void mix_meshes(struct mix_mesh meshes[STAGE_MESHES], const struct stage *stage);

/* Make mix number `number`, which alone determines objects and views. align_x, align_y: the target's. */
void mix_make(struct mix *mix, unsigned number, const struct mix_mesh meshes[STAGE_MESHES], int align_x, int align_y);

/*
 * Make a frame to follow *from, another one: objects stay, move, leave or come back; now and then the view changes. All
 * its objects are among those of the mix.
 */
void mix_next(uint32_t *seed, const struct mix *mix, const struct mix_frame *from, struct mix_frame *to, int align_x,
              int align_y);

unsigned mix_shaders(void);
const char *mix_shader_name(unsigned shader);

/* Print what the mix consists of, for the message of a failure. */
void mix_print(const struct mix *mix);

#endif
