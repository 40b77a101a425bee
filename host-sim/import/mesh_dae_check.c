/*
 * mesh_dae_check.c - checks the structure of a COLLADA file while expat parses it, and its references at the end.
 */
#include "mesh_dae_check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mesh_dae.h"

/* Appends a zeroed item to the list and returns it, or NULL. Earlier items may move. */
static void *add(struct list *list, size_t size)
{
    if (list->count == list->room) {
        size_t room = list->room ? 2 * list->room : 16;
        void *items = realloc(list->items, room * size);
        if (!items)
            return NULL;
        list->items = items;
        list->room = room;
    }
    void *item = (char *)list->items + list->count++ * size;
    return memset(item, 0, size);
}

static const char *attribute(const char **attributes, const char *name)
{
    for (; *attributes; attributes += 2) {
        if (strcmp(attributes[0], name) == 0)
            return attributes[1];
    }
    return "";
}

/* A number of 32 bits, so that products of two fit into 64. */
static long long number(struct dae *dae, const char **attributes, const char *name, long long otherwise)
{
    const char *text = attribute(attributes, name);
    long long value = *text ? strtoll(text, NULL, 10) : otherwise;

    if (value == (int32_t)value)
        return value;
    sheen_dae_refuse(dae, line_of(dae), "%s=\"%.60s\" is too large a number", name, text);
    return otherwise;
}

static void copy_id(struct dae *dae, char to[NAME], const char *id)
{
    id += *id == '#';
    if (snprintf(to, NAME, "%s", id) >= NAME)
        sheen_dae_refuse(dae, line_of(dae), "an id of more than %d bytes", NAME - 1);
}

/* ---- elements that begin ---- */

static void begin_source(struct dae *dae, const char **attributes)
{
    dae->source = add(&dae->sources, sizeof *dae->source);
    if (!dae->source) {
        sheen_dae_no_memory(dae);
        return;
    }
    dae->source->stride = 1;
    copy_id(dae, dae->source->id, attribute(attributes, "id"));
}

/* <vertices> stands for the source of its POSITION; in a primitive only vertices and normals are checked. */
static void begin_input(struct dae *dae, const char **attributes)
{
    const char *semantic = attribute(attributes, "semantic");
    long long offset = number(dae, attributes, "offset", 0);

    if (!dae->primitive[0]) {
        if (dae->source && strcmp(semantic, "POSITION") == 0)
            copy_id(dae, dae->source->same_as, attribute(attributes, "source"));
        return;
    }
    if (offset < 0 || offset >= OFFSETS) {
        sheen_dae_refuse(dae, line_of(dae), "an input with offset %lld, not 0 to %d", offset, OFFSETS - 1);
        return;
    }
    dae->stride = offset + 1 > dae->stride ? offset + 1 : dae->stride;
    int is_vertex = strcmp(semantic, "VERTEX") == 0;
    if (!is_vertex && strcmp(semantic, "NORMAL") != 0)
        return;
    struct use *use = add(&dae->uses, sizeof *use);
    if (!use) {
        sheen_dae_no_memory(dae);
        return;
    }
    use->what = is_vertex ? "vertex" : "normal";
    use->highest = -1;
    copy_id(dae, use->source, attribute(attributes, "source"));
    if (!dae->use_at[offset] || is_vertex)
        dae->use_at[offset] = dae->uses.count;
}

static int is_primitive(const char *name)
{
    return strcmp(name, "triangles") == 0 || strcmp(name, "polylist") == 0 || strcmp(name, "polygons") == 0 ||
           strcmp(name, "tristrips") == 0;
}

static void begin_primitive(struct dae *dae, const char *name, const char **attributes)
{
    snprintf(dae->primitive, sizeof dae->primitive, "%s", name);
    memset(dae->use_at, 0, sizeof dae->use_at);
    dae->count = number(dae, attributes, "count", -1);
    dae->lists = dae->corners = dae->stride = 0;
    dae->faces = -1;
}

/* Refuses elements that assimp silently leaves out. */
static void look_for_left_out(struct dae *dae, const char *name, const char **attributes)
{
    unsigned long line = line_of(dae);

    if (strcmp(name, "ph") == 0)
        sheen_dae_refuse(dae, line, "polygons with holes (ph) are not read");
    else if (strcmp(name, "trifans") == 0)
        sheen_dae_refuse(dae, line, "trifans are not read; triangulate it");
    else if (strcmp(name, "spline") == 0 || strcmp(name, "brep") == 0)
        sheen_dae_refuse(dae, line, "a shape of sort %s is not read, only meshes are", name);
    else if (strcmp(name, "convex_mesh") == 0 && *attribute(attributes, "convex_hull_of"))
        sheen_dae_refuse(dae, line, "a convex_mesh that is the hull of another is not read");
    else if (strcmp(name, "skew") == 0 && dae->in_node)
        sheen_dae_refuse(dae, line, "a node that is skewed is not read");
    else if (strncmp(name, "instance_", 9) == 0 && dae->in_node &&
             strstr(attribute(attributes, "url"), "#") > attribute(attributes, "url"))
        sheen_dae_refuse(dae, line, "it wants a shape from another file, %.60s", attribute(attributes, "url"));
}

static void keep_text(struct dae *dae)
{
    dae->keeps_text = 1;
    dae->text_count = 0;
    dae->text_line = line_of(dae);
}

static void XMLCALL begin(void *user, const char *name, const char **attributes)
{
    struct dae *dae = user;

    look_for_left_out(dae, name, attributes);
    dae->in_node += strcmp(name, "node") == 0;
    dae->shown += dae->in_node && strncmp(name, "instance_", 9) == 0;
    if (strcmp(name, "source") == 0 || strcmp(name, "vertices") == 0)
        begin_source(dae, attributes);
    else if (is_primitive(name))
        begin_primitive(dae, name, attributes);
    else if (strcmp(name, "input") == 0)
        begin_input(dae, attributes);
    else if (strcmp(name, "p") == 0 ? dae->primitive[0] : strcmp(name, "vcount") == 0)
        keep_text(dae);
    if (!dae->source)
        return;
    if (strcmp(name, "float_array") == 0) {
        dae->source->promised = number(dae, attributes, "count", 0);
        keep_text(dae);
    } else if (strcmp(name, "accessor") == 0) {
        dae->source->accessor = number(dae, attributes, "count", 0);
        dae->source->stride = number(dae, attributes, "stride", 1);
        dae->source->offset = number(dae, attributes, "offset", 0);
    }
}

static void end_primitive(struct dae *dae)
{
    int is_list = strcmp(dae->primitive, "triangles") == 0 || strcmp(dae->primitive, "polylist") == 0;
    long long came = dae->faces >= 0 ? dae->faces : is_list ? dae->count : dae->lists;

    if (dae->count >= 0 && came != dae->count)
        sheen_dae_refuse(dae, line_of(dae), "%lld %s, but there are %lld", dae->count, dae->primitive, came);
    else if (is_list && dae->count > 0 && dae->lists == 0)
        sheen_dae_refuse(dae, line_of(dae), "%lld %s without indices (p)", dae->count, dae->primitive);
    else if (dae->count < 0 && strcmp(dae->primitive, "triangles") == 0)
        sheen_dae_refuse(dae, line_of(dae), "triangles without a count");
    dae->primitive[0] = '\0';
}

static void XMLCALL end(void *user, const char *name)
{
    struct dae *dae = user;

    dae->in_node -= strcmp(name, "node") == 0;
    if (dae->keeps_text && strcmp(name, "float_array") == 0)
        sheen_dae_array(dae);
    else if (dae->keeps_text && strcmp(name, "vcount") == 0)
        sheen_dae_vcount(dae);
    else if (dae->keeps_text && strcmp(name, "p") == 0)
        sheen_dae_indices(dae);
    else if (is_primitive(name))
        end_primitive(dae);
    else if (strcmp(name, "source") == 0 || strcmp(name, "vertices") == 0)
        dae->source = NULL;
    else
        return;
    dae->keeps_text = 0;
    dae->text_count = 0;
}

static void parse(struct dae *dae, const struct sheen_bytes *bytes)
{
    XML_SetUserData(dae->parser, dae);
    XML_SetElementHandler(dae->parser, begin, end);
    XML_SetCharacterDataHandler(dae->parser, sheen_dae_text);
    enum XML_Status status = bytes->count > INT32_MAX
                                 ? XML_STATUS_ERROR
                                 : XML_Parse(dae->parser, (const char *)bytes->bytes, (int)bytes->count, 1);
    if (status == XML_STATUS_ERROR && !dae->error) {
        enum XML_Error code = XML_GetErrorCode(dae->parser);
        if (code == XML_ERROR_NO_MEMORY)
            dae->error = SHEEN_ERR_MEMORY;
        else
            sheen_dae_refuse(dae, line_of(dae), "its XML %s: %s",
                             code == XML_ERROR_NO_ELEMENTS || code == XML_ERROR_UNCLOSED_TOKEN ? "is cut short"
                                                                                               : "is broken",
                             XML_ErrorString(code));
    }
    if (!dae->error)
        sheen_dae_check_uses(dae);
    if (!dae->error && dae->uses.count && !dae->shown)
        dae->error = sheen_problem(dae->problem, SHEEN_ERR_ARGUMENT,
                                   "%s: no faces: no node of its scenes shows any of its shapes", dae->path);
}

int sheen_dae_check(const char *path, struct sheen_problem *problem)
{
    struct dae dae = {.path = path, .problem = problem};
    struct sheen_bytes bytes;
    int error = sheen_bytes_load(&bytes, path, problem);

    if (!error) {
        dae.parser = XML_ParserCreate(NULL);
        if (dae.parser)
            parse(&dae, &bytes);
        else
            dae.error = SHEEN_ERR_MEMORY;
        error = dae.error;
    }
    if (dae.parser)
        XML_ParserFree(dae.parser);
    free(dae.sources.items);
    free(dae.uses.items);
    free(dae.text);
    sheen_bytes_free(&bytes);
    return error;
}
