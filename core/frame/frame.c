/*
 * frame.c - the main path: begin, draw, end. (init is in arena.c, the bands in band.c, their pushes in send.c)
 */
#include <string.h>

#include "../math/pose.h"
#include "frame.h"

/*
 * Two runs of fields in struct sheen_frame: the counters that sheen_begin() zeroes, and the part of them that is
 * restored when a draw fails, so that it fails as a whole.
 */
#define COUNTED_BYTES (offsetof(struct sheen_frame, bands) - offsetof(struct sheen_frame, edges))
#define UNDONE_BYTES (offsetof(struct sheen_frame, count.edges) - offsetof(struct sheen_frame, used_short))

/* ---- begin ---- */

static APART int same_rect(const struct sheen_rect *a, const struct sheen_rect *b)
{
    return a->x0 == b->x0 && a->y0 == b->y0 && a->x1 == b->x1 && a->y1 == b->y1;
}

/* Whether two views have the same background, of which the user's own 2D is a part. */
static APART int same_background(const struct sheen_view *a, const struct sheen_view *b)
{
    for (int k = 0; k < 3; k++)
        if (a->background[k] != b->background[k])
            return 0;
    return a->underlay == b->underlay && a->overlay == b->overlay &&
           (a->ctx == b->ctx || (a->underlay == NULL && a->overlay == NULL));
}

/* The viewport asked for, by default the target; 0 if it leaves that or its edges are not aligned, as pushes need. */
static int viewport_of(const struct sheen_target *t, const struct sheen_rect *asked, struct sheen_rect *viewport)
{
    const struct sheen_rect all = {0, 0, (int16_t)t->width, (int16_t)t->height};
    struct sheen_rect aligned;

    *viewport = aligned = rect_empty(*asked) ? all : *asked;
    sheen_rect_align(&aligned, t);
    sheen_rect_cut(&aligned, &all);
    return same_rect(&aligned, viewport);
}

static void workers_begin(struct sheen_frame *f)
{
    for (unsigned i = 0; i < f->config.workers; i++) {
        struct worker *w = &f->worker[i];
        w->last_band = -2; /* `pending` is of no band yet */
        w->most_carried = 0;
        memset(&w->count, 0, sizeof *w - offsetof(struct worker, count));
    }
}

/* What the last frame touched becomes stale: it has to be drawn over. A frame that sends everything ignores that. */
static void bands_begin(struct sheen_frame *f)
{
    uint32_t rows = f->config.band_rows;

    OPAQUE(rows); /* else gcc makes this a signed division, whose routine nothing else links */
    f->bands = QUOTIENT((unsigned)(f->viewport.y1 - f->viewport.y0) + rows - 1, rows);
    f->bands_left = f->bands;
    f->band_scale = QUOTIENT((1u << 20) + rows - 1, rows);
    memset(f->done, 0, (f->max_bands + 31u) / 32 * sizeof *f->done);
    for (unsigned b = 0; b < f->bands; b++)
        f->band[b].stale = f->band[b].cover;
    sheen_bin_clear(f);
}

/* Check a view, and derive the projection, the screen and the fog from it; returns what is wrong with the view. */
static enum sheen_subject view_begin(struct sheen_frame *f, const struct sheen_view *view)
{
    struct projection *p = &f->projection;
    struct screen *screen = &f->screen;
    struct sheen_rect *viewport = &screen->viewport;
    const struct sheen_fog *fog = view->fog;

    if (!viewport_of(f->target, &view->viewport, viewport))
        return SHEEN_ABOUT_VIEWPORT;
    if (!sheen_pose_valid(&view->pose))
        return SHEEN_ABOUT_VIEW_POSE;
    if (sheen_project_begin(p, view, (unsigned)(viewport->x1 - viewport->x0), (unsigned)(viewport->y1 - viewport->y0)) <
        0)
        return sheen_fov(view) == 0 ? SHEEN_ABOUT_FOV : SHEEN_ABOUT_DEPTHS;
    if (fog != NULL && (fog->mixer == NULL || fog->mixer->begin(&f->fog, fog, p, &f->format) < 0))
        return SHEEN_ABOUT_FOG;
    screen->centre_x = SUBPIXEL_HALF * (viewport->x0 + viewport->x1);
    screen->centre_y = SUBPIXEL_HALF * (viewport->y0 + viewport->y1);
    screen->weight_offset = p->weight_offset;
    screen->weight_shift = (uint8_t)p->weight_shift;
    screen->flat_weight = view->affine || p->orthographic != 0;
    screen->shared_rows = 0;
    return SHEEN_ABOUT_NOTHING;
}

COLD int sheen_begin(struct sheen_frame *f, const struct sheen_view *view)
{
    if (f->state != IDLE)
        return SHEEN_ERR_STATE;
    int error = sheen_wait(f);
    if (error < 0)
        return error;
    const enum sheen_subject problem = view_begin(f, view);
    if (problem != SHEEN_ABOUT_NOTHING)
        return refuse(f, SHEEN_ERR_ARGUMENT, problem, 0);
    f->send_all = f->send_all_next || !same_rect(&f->screen.viewport, &f->viewport) || !same_background(view, &f->view);
    f->send_all_next = 0;
    f->view = *view;
    f->viewport = f->screen.viewport;
    memset((char *)f + offsetof(struct sheen_frame, edges), 0, COUNTED_BYTES);
    workers_begin(f);
    bands_begin(f);
    f->state = OPEN;
    return SHEEN_OK;
}

/* ---- draw: transform, clip, bin, light ---- */

/* Transform those of `count` vertices that are used for the first time; 0 if one of them finds no room. */
int sheen_use_corners(struct sheen_frame *f, const struct draw_record *d, const struct transform *t,
                      const uint32_t *index, int count)
{
    const uint32_t none = f->config.max_used;
    int16_t store[3];
    int all = 1;

    for (int k = 0; k < count; k++) {
        uint16_t *place = &f->place[d->first_vertex + index[k]];
        if (*place < none)
            continue;
        if (*place == NO_PLACE && f->used < none) {
            const int16_t *position = position_of(&d->as, d->as.mesh->positions + 3 * index[k], store);
            struct point point = sheen_transform_point(t, position);
            sheen_project(&f->projection, t->screen_shift, &point, &f->vertex[f->used]);
            *place = (uint16_t)f->used++;
            continue;
        }
        f->used_short += *place == NO_PLACE;
        *place = (uint16_t)none;
        all = 0;
    }
    return all;
}

/* Light `count` corners of a listed entry, each vertex only once. v points into f->vertex. */
void sheen_light_corners(const struct draw *d, const struct vertex *const v[], const uint32_t *index, int count)
{
    for (int k = 0; k < count; k++) {
        int16_t store[3];
        if ((v[k]->flags & LIT) != 0)
            continue;
        struct vertex *lit = (struct vertex *)v[k];
        d->shader->light(d, normal_of(d, d->mesh->normals + 3 * index[k], store), lit->kept);
        lit->flags |= LIT;
    }
}

/* Cut a triangle that leaves the view volume; without a clipper, only the pieces that it might need are counted. */
static void clip_triangle(struct sheen_frame *f, const struct draw_record *d, const struct transform *t,
                          uint16_t triangle)
{
    if (f->config.clipper != NULL)
        f->config.clipper->cut(f, d, t, triangle);
    else
        f->pieces_short += MOST_PIECES;
}

/* Cull, clip and list one triangle. */
static void draw_triangle(struct sheen_frame *f, const struct draw_record *d, const struct transform *t,
                          const uint16_t *place, uint32_t triangle)
{
    const uint32_t index[3] = {mesh_index(d->as.mesh, 3 * triangle), mesh_index(d->as.mesh, 3 * triangle + 1),
                               mesh_index(d->as.mesh, 3 * triangle + 2)},
                   none = f->config.max_used;

    SHEEN_TAP(LOOKED_AT, 1);
    if ((place[index[2]] >= none || place[index[1]] >= none || place[index[0]] >= none) &&
        !sheen_use_corners(f, d, t, index, 3))
        return;
    const struct vertex *const v[4] = {f->vertex + place[index[0]], f->vertex + place[index[1]],
                                       f->vertex + place[index[2]]};
    unsigned all = v[0]->flags & v[1]->flags & v[2]->flags, any = v[0]->flags | v[1]->flags | v[2]->flags;
    if ((any & OUTSIDE) != 0) {
        if ((all & OUTSIDE) == 0)
            clip_triangle(f, d, t, (uint16_t)triangle);
        return;
    }
    int64_t area = (any & OFF_VIEW) == 0 ? small_twice_area(v[0], v[1], v[2]) : sheen_twice_area(v[0], v[1], v[2]);
    if (area >= 0 && (area == 0 || !d->as.two_sided))
        return;
    f->count.front++;
    if (sheen_bin_triangle(f, v, triangle, any) && (all & LIT) == 0 && d->as.shader->light != NULL)
        sheen_light_corners(&d->as, v, index, 3);
}

/* What is missing or out of range in an object, or SHEEN_ABOUT_NOTHING. */
static APART enum sheen_subject object_problem(const struct sheen_object *o)
{
    const uint32_t most = 4 << 16; /* of intensities; a negative one, as unsigned, is larger */
    const struct sheen_mesh *mesh = o->mesh;
    const struct sheen_material *m = o->material;
    const struct sheen_shader *shader = o->shader;

    if (mesh == NULL || mesh->positions == NULL || mesh->indices == NULL || mesh->scale <= 0 ||
        mesh->index_bytes - 1u > 1)
        return SHEEN_ABOUT_MESH;
    if (m == NULL || (uint32_t)m->ambient > most || (uint32_t)m->diffuse > most || (uint32_t)m->specular > most)
        return SHEEN_ABOUT_MATERIAL;
    if (m->shine == NULL ? m->specular > 0 : m->shine->shininess == 0 || m->shine->shift > 3)
        return SHEEN_ABOUT_SHINE;
    if (m->ramp != NULL && m->ramp->reader == NULL)
        return SHEEN_ABOUT_RAMP;
    if (shader == NULL)
        return SHEEN_ABOUT_SHADER;
    if (mesh->normals == NULL && shader->needs_normals)
        return SHEEN_ABOUT_NORMALS;
    if ((mesh->uvs == NULL || mesh->uv_bits > 15) && shader->needs_uvs)
        return SHEEN_ABOUT_UVS;
    if (shader->takes != NULL && !shader->takes(m->texture))
        return SHEEN_ABOUT_TEXTURE;
    if (o->depth_bias < -4096 || o->depth_bias > 4095)
        return SHEEN_ABOUT_DEPTH_BIAS;
    if (o->morph != NULL && (o->morph->morpher == NULL || !o->morph->morpher->fits(o)))
        return SHEEN_ABOUT_MORPH;
    return SHEEN_ABOUT_NOTHING;
}

/* SHEEN_OK, or SHEEN_ERR_CAPACITY if more than `most` are needed. */
static int room_for(struct sheen_frame *f, uint32_t needed, uint32_t most, enum sheen_subject subject)
{
    return needed <= most ? SHEEN_OK : refuse(f, SHEEN_ERR_CAPACITY, subject, needed);
}

/*
 * Make a draw's transform, its lights in the model's space, and its viewpoint (margin_per_warp 0: polygons are not
 * tested).
 */
static int place_object(struct sheen_frame *f, const struct sheen_object *o, struct draw *d, struct transform *t,
                        struct viewpoint *viewpoint)
{
    struct sheen_pose pose;
    const struct sheen_pose *view = &f->view.pose;
    int posed = !sheen_pose_is_zero(view);

    if (sheen_pose_place(view, &o->pose, &pose) < 0 || sheen_transform_begin(t, &f->projection, o->mesh, &pose) < 0)
        return refuse(f, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_POSE, 0);
    sheen_viewpoint_begin(viewpoint, &f->projection, o->mesh, &pose);
    if (o->two_sided || o->morph != NULL) /* back faces are wanted; a warp holds for one frame of a mesh */
        viewpoint->margin_per_warp = 0;
    const struct sheen_light *axes = o->shader->axes;
    int error = sheen_light_begin(
        &d->light, axes != NULL ? axes : o->lights, axes != NULL ? 2 : o->light_count, pose.rotation,
        posed && !sheen_rotation_is_zero(view->rotation) ? view->rotation : NULL, (enum lights_taken)o->shader->lights);
    return error < 0 ? refuse(f, error, SHEEN_ABOUT_LIGHTS, 0) : SHEEN_OK;
}

/*
 * Draw every triangle that may face the eye, even beyond a capacity, so that the error tells how many are needed: 0, or
 * SHEEN_ERR_CAPACITY. If used vertices are short, the triangles and pieces that they would have made are unknown.
 */
static int draw_triangles(struct sheen_frame *f, const struct draw_record *d, const struct transform *t,
                          const struct viewpoint *viewpoint)
{
    const struct sheen_mesh *mesh = d->as.mesh;
    uint16_t *const place = f->place + d->first_vertex;
    uint32_t faces = UINT32_MAX, end = mesh->triangles;
    int quads = 0;

    memset(place, 0xff, mesh->vertices * sizeof *place);
    for (uint32_t i = 0; i < end; i++) {
        if (viewpoint->margin_per_warp != 0 && (mesh->polygons == NULL || mesh->polygons[i] != faces)) {
            i = sheen_next_facing(viewpoint, mesh, i, &faces);
            if (i == end)
                break;
            quads = d->as.quads != 0 && mesh->warp[faces] <= d->as.quads;
        }
        if (quads && f->config.quads->list(f, d, t, place, i))
            i++;
        else
            draw_triangle(f, d, t, place, i);
    }
    if (f->used_short > 0)
        return refuse_used(f, f->config.max_used + f->used_short);
    int error = room_for(f, f->pieces + f->pieces_short, f->config.max_clipped, SHEEN_ABOUT_MAX_CLIPPED);
    if (error == SHEEN_OK)
        error = room_for(f, f->entries + f->entries_short, f->config.max_triangles, SHEEN_ABOUT_MAX_TRIANGLES);
    return error;
}

/* Fill in what a draw keeps of its material, and how it is shaded; its lights have to be set. */
static void begin_colours(struct sheen_frame *f, struct draw *d, const struct sheen_object *object)
{
    const struct sheen_material *m = object->material;
    struct sheen_material ramped;

    d->power = power_of(m->shine);
    d->strong = m->specular > SHEEN_Q16(0.5);
    d->pixel_ramp = 0;
    if (m->ramp != NULL)
        m = m->ramp->reader->begin(d, m, &ramped, d->shader->at_pixels);
    sheen_colour_begin(&d->colour, &f->format, m, d->light.diffuse_sum, d->light.specular_sum);
    d->shades = NULL;
    if (d->shader->find_shades != NULL)
        d->shades = d->shader->find_shades(d, f->shades, f->config.max_shades, &f->shaded_colors);
    sheen_power_end(&d->power, &d->colour, &f->format, d->dither);
    if (d->shader->begin != NULL)
        d->shader->begin(d, m, &f->format, object, &f->view.pose);
    d->fog = NULL;
    if (f->view.fog != NULL)
        f->fog.mixer->draw(d, &f->fog);
}

/* Fill in what a draw's triangles and vertices need, and the viewpoint. */
static int begin_draw(struct sheen_frame *f, const struct sheen_object *object, struct draw *d, struct transform *t,
                      struct viewpoint *viewpoint)
{
    int error = place_object(f, object, d, t, viewpoint);

    if (error < 0)
        return error;
    d->mesh = object->mesh;
    d->morph = object->morph;
    d->shader = object->shader;
    d->two_sided = object->two_sided;
    d->dither = f->view.dither != 0;
    d->is_565 = !f->format.grey;
    d->swap = f->format.swap;
    d->forced = f->forced;
    d->stippled = STIPPLED_NOT;
    d->depth_bias = object->depth_bias;
    begin_colours(f, d, object);
    d->quads = f->config.quads != NULL ? f->config.quads->most(f, d) : 0;
    if (object->transparency != 0) {
        if (object->stipple == NULL || object->stipple->begin(d, object) < 0)
            return refuse(f, SHEEN_ERR_ARGUMENT, SHEEN_ABOUT_TRANSPARENCY, 0);
        f->stipple = object->stipple;
    }
    return SHEEN_OK;
}

int sheen_draw(struct sheen_frame *f, const struct sheen_object *object)
{
    struct transform t;
    struct viewpoint viewpoint;
    char *const taken = (char *)f + offsetof(struct sheen_frame, used_short), before[UNDONE_BYTES];
    const uint32_t entries = f->entries;
    struct draw_record *d = &f->draw[f->draws];

    if (f->state != OPEN)
        return SHEEN_ERR_STATE;
    enum sheen_subject problem = object_problem(object);
    if (problem != SHEEN_ABOUT_NOTHING)
        return refuse(f, SHEEN_ERR_ARGUMENT, problem, 0);
    memcpy(before, taken, UNDONE_BYTES);
    int error = room_for(f, f->draws + 1, f->config.max_draws, SHEEN_ABOUT_MAX_DRAWS);
    if (error == SHEEN_OK)
        error = room_for(f, f->vertices + object->mesh->vertices, f->config.max_vertices, SHEEN_ABOUT_MAX_VERTICES);
    if (error == SHEEN_OK)
        error = begin_draw(f, object, &d->as, &t, &viewpoint);
    if (error == SHEEN_OK) {
        d->first_vertex = f->vertices;
        d->edges = object->edges;
        error = draw_triangles(f, d, &t, &viewpoint);
        if (error == SHEEN_OK && d->edges != NULL)
            error = d->edges->list(f, d, object, &t);
    }
    if (error < 0) {
        memcpy(taken, before, UNDONE_BYTES);
        sheen_bin_rollback(f, entries);
        return error;
    }
    d->end_entry = f->entries;
    f->vertices += object->mesh->vertices;
    f->draws++;
    f->count.triangles += object->mesh->triangles;
    f->count.drawn += f->entries - entries;
    return SHEEN_OK;
}

int sheen_mark(struct sheen_frame *f, struct sheen_rect rect)
{
    if (f->state != OPEN)
        return SHEEN_ERR_STATE;
    for (unsigned b = 0; b < f->bands; b++) {
        struct sheen_rect strip;
        sheen_band_strip(f, b, &strip);
        sheen_rect_cut(&strip, &rect);
        if (!rect_empty(strip))
            sheen_rect_unite(&f->band[b].stale, &strip);
    }
    return SHEEN_OK;
}

/* ---- end: the bands are in band.c ---- */

unsigned sheen_band_count(const struct sheen_frame *f)
{
    return f->bands;
}

int sheen_finish(struct sheen_frame *f)
{
    if (f->state == IDLE)
        return SHEEN_ERR_STATE;
    if (f->bands_left > 0)
        f->send_all_next = 1;
    f->state = IDLE;
    return f->error;
}

int sheen_end(struct sheen_frame *f)
{
    if (f->state == IDLE)
        return SHEEN_ERR_STATE;
    for (unsigned b = 0; b < f->bands && f->error == 0; b++)
        if ((f->done[b >> 5] >> (b & 31u) & 1u) == 0)
            (void)sheen_band(f, 0, b); /* its error is kept in f->error */
    return sheen_finish(f);
}

int sheen_render(struct sheen_frame *f, const struct sheen_view *view, const struct sheen_object *objects,
                 unsigned count)
{
    int error = sheen_begin(f, view);

    if (error < 0)
        return error;
    for (unsigned i = 0; i < count && error == SHEEN_OK; i++)
        error = sheen_draw(f, &objects[i]);
    if (error == SHEEN_OK)
        return sheen_end(f);
    (void)sheen_finish(f); /* no band is done, so the next frame sends everything */
    return error;
}

void sheen_invalidate(struct sheen_frame *f)
{
    f->send_all_next = 1;
}
