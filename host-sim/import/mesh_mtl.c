/*
 * mesh_mtl.c - the colours and textures of an OBJ's materials.
 */
#include <string.h>

#include "mesh_readers.h"
#include "mesh_sink.h"

/* Whether the group has the material's name. In the OBJ a comment may follow it, but names may contain a # too. */
static int is_named(const struct sheen_word *group, const struct sheen_word *material)
{
    if (group->length < material->length || memcmp(group->at, material->at, material->length) != 0)
        return 0;
    size_t i = material->length;
    while (i < group->length && (group->at[i] == ' ' || group->at[i] == '\t'))
        i++;
    return i == group->length || (i > material->length && group->at[i] == '#');
}

/* The material's group; NULL if no face uses it or if it already has a colour or texture. */
static struct sheen_group *find_group(struct sheen_polygons *polygons, const struct sheen_word *names,
                                      const struct sheen_word *material)
{
    for (size_t g = 1; g < polygons->group_count; g++) {
        if (is_named(&names[g], material))
            return polygons->group[g].has_color || polygons->group[g].picture ? NULL : &polygons->group[g];
    }
    return NULL;
}

/* Reads what follows Kd: r g b, or one number for all three, in sRGB. `Kd xyz` and `Kd spectral` are left out. */
static void read_color(struct sheen_text *text, struct sheen_group *group, struct sheen_notes *notes)
{
    double parts[3];
    int count = 0;
    struct sheen_word word;

    while (count < 3 && sheen_text_word(text, &word) && sheen_word_number(&word, &parts[count]))
        count++;
    if (count == 0 || count == 2) {
        sheen_note(notes, SHEEN_NOTE_ON_COLORS, "%s:%lu: a colour that is not three numbers is left out", text->path,
                   text->line);
        return;
    }
    for (int k = 0; k < 3; k++)
        group->color[k] = sheen_color_byte(parts[count == 3 ? k : 0], 1);
    group->has_color = 1;
}

/*
 * Reads what follows d: an opacity, where 1 is opaque, maybe after -halo. Tr is not read, because some programs write 1
 * for opaque and others 0.
 */
static void note_opacity(struct sheen_text *text, struct sheen_notes *notes)
{
    struct sheen_word word;
    double opacity;

    if (!sheen_text_word(text, &word) || (sheen_word_is(&word, "-halo") && !sheen_text_word(text, &word)))
        return;
    if (sheen_word_number(&word, &opacity) && opacity < 1)
        sheen_note(notes, SHEEN_NOTE_WARNING, "%s: the transparency (d) of its materials is not read", text->path);
}

/* ---- map_Kd ---- */

/* At least `least` and at most `most` words follow an option; those beyond the least are numbers. */
static const struct map_option {
    const char *name;
    int least, most;
} map_options[] = {{"-blendu", 1, 1}, {"-blendv", 1, 1}, {"-cc", 1, 1},      {"-clamp", 1, 1},  {"-mm", 2, 2},
                   {"-o", 1, 3},      {"-s", 1, 3},      {"-t", 1, 3},       {"-texres", 1, 1}, {"-bm", 1, 1},
                   {"-boost", 1, 1},  {"-type", 1, 1},   {"-imfchan", 1, 1}, {NULL, 0, 0}};

struct map {
    double offset[3], scale[3];
    int clamps;
};

/* Reads the words of one option and leaves the text after them. Returns 0 if the text ends there. */
static int read_map_option(struct sheen_text *text, const struct map_option *option, struct map *map)
{
    double *numbers = option->name[1] == 'o' ? map->offset : option->name[1] == 's' ? map->scale : NULL;

    for (int i = 0; i < option->most; i++) {
        struct sheen_text before = *text;
        struct sheen_word word;
        double number = 0;
        int is_number = sheen_text_word(text, &word) && sheen_word_number(&word, &number);
        if (!is_number && i >= option->least) {
            *text = before;
            break;
        }
        if (numbers && is_number)
            numbers[i] = number;
        if (option->name[1] == 'c' && option->name[2] == 'l')
            map->clamps = sheen_word_is(&word, "on");
    }
    return text->at < text->end;
}

/* Reads the options before the name of the picture. */
static void read_map_options(struct sheen_text *text, struct map *map)
{
    for (;;) {
        struct sheen_text before = *text;
        struct sheen_word word;
        const struct map_option *option = map_options;
        if (!sheen_text_word(text, &word))
            return;
        while (option->name && !sheen_word_is(&word, option->name))
            option++;
        if (!option->name) {
            *text = before;
            return;
        }
        if (!read_map_option(text, option, map))
            return;
    }
}

/* Applies -s and -o to u and v. In the file v counts upwards, in *polygons downwards. */
static void transform(struct sheen_polygons *polygons, size_t group, const struct map *map)
{
    for (size_t p = 0; polygons->uvs && p < polygons->polygon_count; p++) {
        if (polygons->groups[p] != group)
            continue;
        for (uint32_t c = polygons->first[p]; c < polygons->first[p + 1]; c++) {
            double *uv = polygons->uvs[c];
            uv[0] = map->scale[0] * uv[0] + map->offset[0];
            uv[1] = 1 - (map->scale[1] * (1 - uv[1]) + map->offset[1]);
        }
    }
}

static void read_map(struct sheen_text *text, struct sheen_polygons *polygons, struct sheen_group *group)
{
    struct map map = {.scale = {1, 1, 1}};
    struct sheen_word name;

    read_map_options(text, &map);
    if (group->picture || !sheen_text_line_rest(text, &name))
        return;
    sheen_word_unquote(&name);
    uint8_t wrap = map.clamps ? SHEEN_WRAP_CLAMP : SHEEN_WRAP_REPEAT;
    struct sheen_picture picture = {
        .name = sheen_picture_beside(text->path, name.at, name.length), .wrap = {wrap, wrap}, .cutoff = .5};
    group->picture = sheen_polygons_picture(polygons, &picture);
    transform(polygons, (size_t)(group - polygons->group), &map);
}

static void read_lines(struct sheen_polygons *polygons, const struct sheen_word *names, struct sheen_text *text)
{
    struct sheen_group *group = NULL;
    struct sheen_word word, name;

    for (; sheen_text_any_word(text, &word); sheen_text_skip_line(text)) {
        if (sheen_word_is(&word, "newmtl") && sheen_text_line_rest(text, &name))
            group = find_group(polygons, names, &name);
        else if (group && sheen_word_is(&word, "Kd"))
            read_color(text, group, &polygons->notes);
        else if (group && sheen_word_is(&word, "map_Kd"))
            read_map(text, polygons, group);
        else if (group && sheen_word_is(&word, "d"))
            note_opacity(text, &polygons->notes);
        else if (group && sheen_word_is(&word, "map_d"))
            sheen_note(&polygons->notes, SHEEN_NOTE_WARNING,
                       "%s: map_d is not read; transparency comes from the alpha of map_Kd's picture", text->path);
    }
}

int sheen_mtl_read(struct sheen_polygons *polygons, const struct sheen_word *names, const char *path)
{
    struct sheen_problem problem;
    struct sheen_bytes bytes;
    int error = sheen_bytes_load(&bytes, path, &problem);

    if (!error)
        error = sheen_bytes_to_utf8(&bytes);
    if (!error) {
        struct sheen_text text = {.path = path,
                                  .at = (const char *)bytes.bytes,
                                  .end = (const char *)bytes.bytes + bytes.count,
                                  .line = 1,
                                  .comments = 1,
                                  .problem = &problem};
        read_lines(polygons, names, &text);
    }
    sheen_bytes_free(&bytes);
    return error ? -1 : 0;
}
