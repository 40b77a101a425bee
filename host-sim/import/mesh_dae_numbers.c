/*
 * mesh_dae_numbers.c - checks the numbers of a COLLADA file's geometries against the counts that it promises.
 */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mesh_dae.h"

void sheen_dae_refuse(struct dae *dae, unsigned long line, const char *format, ...)
{
    char what[200];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    if (!dae->error)
        dae->error = sheen_problem(dae->problem, SHEEN_ERR_ARGUMENT, "%s:%lu: %s", dae->path, line, what);
    XML_StopParser(dae->parser, XML_FALSE);
}

void sheen_dae_no_memory(struct dae *dae)
{
    dae->error = SHEEN_ERR_MEMORY;
    XML_StopParser(dae->parser, XML_FALSE);
}

void XMLCALL sheen_dae_text(void *user, const char *text, int length)
{
    struct dae *dae = user;
    size_t more = (size_t)length;

    if (!dae->keeps_text)
        return;
    if (dae->text_count + more + 1 > dae->text_room) {
        size_t room = 2 * (dae->text_count + more + 1);
        char *larger = realloc(dae->text, room);
        if (!larger) {
            sheen_dae_no_memory(dae);
            return;
        }
        dae->text = larger;
        dae->text_room = room;
    }
    memcpy(dae->text + dae->text_count, text, more);
    dae->text_count += more;
    dae->text[dae->text_count] = '\0';
}

static struct sheen_text kept_text(const struct dae *dae)
{
    return (struct sheen_text){.path = dae->path,
                               .at = dae->text_count ? dae->text : "",
                               .end = (dae->text_count ? dae->text : "") + dae->text_count,
                               .line = dae->text_line};
}

/* Only counts: assimp, which also reads a decimal comma, refuses words that are not numbers. */
void sheen_dae_array(struct dae *dae)
{
    struct sheen_text text = kept_text(dae);
    struct sheen_word word;

    while (sheen_text_any_word(&text, &word))
        dae->source->numbers++;
}

void sheen_dae_vcount(struct dae *dae)
{
    struct sheen_text text = kept_text(dae);
    struct sheen_word word;
    int64_t corners;

    for (dae->faces = 0; sheen_text_any_word(&text, &word); dae->faces++) {
        if (!sheen_word_whole(&word, &corners) || corners < 0 || corners > INT32_MAX) {
            sheen_dae_refuse(dae, text.line, "'%.*s' is no count of corners", SHEEN_WORD(word));
            return;
        }
        dae->corners += corners;
    }
}

/* Returns the number of words of a <p>, or -1 if one is not a valid index. */
static long long read_indices(struct dae *dae)
{
    struct sheen_text text = kept_text(dae);
    struct sheen_word word;
    long long words = 0;
    int64_t index;

    for (; sheen_text_any_word(&text, &word); words++) {
        size_t at = dae->stride ? dae->use_at[words % dae->stride] : 0;
        if (!sheen_word_whole(&word, &index) || (at && index < 0)) {
            sheen_dae_refuse(dae, text.line, "a face names %s '%.*s'",
                             at ? ((struct use *)dae->uses.items)[at - 1].what : "an index", SHEEN_WORD(word));
            return -1;
        }
        struct use *use = at ? (struct use *)dae->uses.items + at - 1 : NULL;
        if (use && index > use->highest) {
            use->highest = index;
            use->line = text.line;
        }
    }
    return words;
}

void sheen_dae_indices(struct dae *dae)
{
    long long words = read_indices(dae), stride = dae->stride ? dae->stride : 1;
    int is_list = strcmp(dae->primitive, "triangles") == 0 || strcmp(dae->primitive, "polylist") == 0;
    long long corners = strcmp(dae->primitive, "polylist") == 0 ? dae->corners : 3 * dae->count;

    dae->lists++;
    if (words < 0)
        return;
    if (is_list && dae->lists == 1 && words != corners * stride)
        sheen_dae_refuse(dae, dae->text_line, "%s of %lld corners have %lld indices, not %lld", dae->primitive, corners,
                         words, corners * stride);
    else if (words % stride != 0)
        sheen_dae_refuse(dae, dae->text_line, "%lld indices are no whole number of corners of %lld each", words,
                         stride);
}

static int by_id(const void *a, const void *b)
{
    return strcmp(((const struct source *)a)->id, ((const struct source *)b)->id);
}

static const struct source *find(const struct dae *dae, const char *id)
{
    struct source key;

    snprintf(key.id, sizeof key.id, "%s", id);
    return bsearch(&key, dae->sources.items, dae->sources.count, sizeof key, by_id);
}

static void check_use(struct dae *dae, const struct use *use)
{
    const struct source *source = find(dae, use->source);

    if (source && source->same_as[0])
        source = find(dae, source->same_as);
    if (use->highest < 0)
        return; /* no faces */
    if (!source)
        sheen_dae_refuse(dae, use->line, "there is no source '%.60s'", use->source);
    else if (source->numbers != source->promised)
        sheen_dae_refuse(dae, use->line, "source '%.60s' has %lld of %lld numbers", source->id, source->numbers,
                         source->promised);
    else if (source->accessor < 0 || source->stride < 1 || source->offset < 0 ||
             source->accessor > (source->numbers - source->offset) / source->stride)
        sheen_dae_refuse(dae, use->line, "source '%.60s' has %lld numbers, too few for %lld of %lld", source->id,
                         source->numbers, source->accessor, source->stride);
    else if (use->highest >= source->accessor)
        sheen_dae_refuse(dae, use->line, "a face names %s %lld of %lld, which count from 0", use->what, use->highest,
                         source->accessor);
}

void sheen_dae_check_uses(struct dae *dae)
{
    if (dae->sources.count)
        qsort(dae->sources.items, dae->sources.count, sizeof(struct source), by_id);
    for (size_t i = 0; i < dae->uses.count && !dae->error; i++)
        check_use(dae, (const struct use *)dae->uses.items + i);
}
