/*
 * mesh_mtl.c - the colours of an OBJ's materials.
 */
#include <stdlib.h>
#include <string.h>

#include "mesh_readers.h"
#include "mesh_sink.h"

/* The group's name is the material's; a comment may follow it in the OBJ, though a name may have a # too. */
static int is_named(const struct sheen_word *group, const struct sheen_word *material)
{
    if (group->length < material->length || memcmp(group->at, material->at, material->length) != 0)
        return 0;
    size_t i = material->length;
    while (i < group->length && (group->at[i] == ' ' || group->at[i] == '\t'))
        i++;
    return i == group->length || (i > material->length && group->at[i] == '#');
}

/* NULL: no face uses it, or it has its colour. */
static struct sheen_group *find_group(struct sheen_polygons *polygons, const struct sheen_word *names,
                                      const struct sheen_word *material)
{
    for (size_t g = 1; g < polygons->group_count; g++) {
        if (is_named(&names[g], material))
            return polygons->group[g].has_color ? NULL : &polygons->group[g];
    }
    return NULL;
}

/* After Kd: r g b, or one number for all three; sRGB. `Kd xyz` and `Kd spectral` are left out. */
static void read_color(struct sheen_text *text, struct sheen_group *group, struct sheen_notes *notes)
{
    double parts[3];
    int count = 0;
    struct sheen_word word;

    while (count < 3 && sheen_text_word(text, &word) && sheen_word_number(&word, &parts[count]))
        count++;
    if (count == 0 || count == 2) {
        sheen_note(notes, 1, "%s:%lu: a colour that is not three numbers is left out", text->path, text->line);
        return;
    }
    for (int k = 0; k < 3; k++)
        group->color[k] = sheen_color_byte(parts[count == 3 ? k : 0], 1);
    group->has_color = 1;
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
            sheen_note(&polygons->notes, 1, "%s: textures are not read; a material's colour is its Kd", text->path);
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
