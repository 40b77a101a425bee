/*
 * bake_name.c - which names a baked header and the data in it may have.
 */
#include "bake_name.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "frame_name.h"
#include "utf8.h"

#define MESH "mesh_" /* put before a file's name that is no C identifier or is taken */

/* Keywords of C and C++, main, and macros that compilers or the headers included by sheen.h define. */
static int is_word_taken(const char *name)
{
    static const char taken[] =
        " alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t"
        " char8_t class co_await co_return co_yield compl concept const const_cast consteval constexpr"
        " constinit continue decltype default delete do double dynamic_cast else enum explicit export extern"
        " false float for friend goto if inline int long main mutable namespace new noexcept not not_eq"
        " nullptr operator or or_eq private protected public register reinterpret_cast requires restrict"
        " return short signed sizeof static static_assert static_cast struct switch template this"
        " thread_local throw true try typedef typeid typename typeof union unsigned using virtual void"
        " volatile wchar_t while xor xor_eq CHAR_BIT NULL i386 linux unix ";
    char word[48];

    return snprintf(word, sizeof word, " %s ", name) < (int)sizeof word && strstr(taken, word) != NULL;
}

static int ends_with(const char *name, const char *end)
{
    return strlen(name) >= strlen(end) && strcmp(name + strlen(name) - strlen(end), end) == 0;
}

/* Patterns that C reserves: for the implementation, for type names and for the limits of types. */
static int is_reserved(const char *name)
{
    return (name[0] == '_' && (name[1] == '_' || isupper((unsigned char)name[1]))) || ends_with(name, "_t") ||
           ends_with(name, "_MAX") || ends_with(name, "_MIN");
}

static int is_sheens(const char *name)
{
    return strcmp(name, "sheen") == 0 || strncmp(name, "sheen_", 6) == 0 || strncmp(name, "SHEEN_", 6) == 0;
}

static int is_taken(const char *name)
{
    return is_word_taken(name) || is_reserved(name) || is_sheens(name);
}

int sheen_bake_is_name(const char *name)
{
    size_t length = strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");

    return length > 0 && name[length] == '\0' && length < 40 && !isdigit((unsigned char)*name) && !is_taken(name);
}

/* Puts the prefix before the name, in place; the name's end is cut off if both are longer than size - 1 bytes. */
static void put_before(char *name, size_t size, const char *prefix)
{
    size_t length = strlen(prefix), most = size - 1 - length, kept = strlen(name) < most ? strlen(name) : most;

    memmove(name + length, name, kept);
    memcpy(name, prefix, length);
    name[length + kept] = '\0';
}

void sheen_bake_name(char *name, size_t size, const char *path)
{
    const char *base = sheen_file_of(path);
    const char *prefix = strncmp(base, "builtin:", 8) == 0 ? base + 8 : base;
    size_t length = strcspn(prefix, ".");

    snprintf(name, size, "%s%.*s", length == 0 || isdigit((unsigned char)*prefix) ? MESH : "", (int)length, prefix);
    sheen_utf8_clean(name);
    char *to = name;
    for (const char *c = name; *c;
         c += sheen_utf8_bytes(c)) /* one '_' for each character that a C identifier may not have */
        *to++ = isalnum((unsigned char)*c) ? *c : '_';
    *to = '\0';
    if (is_taken(name) && strncmp(name, MESH, strlen(MESH)) != 0)
        put_before(name, size, MESH);
}

int sheen_bake_is_own_header(const char *path)
{
    static const char *const own[] = {"sheen.h",         "sheen_arena.h",       "sheen_bus.h",    "sheen_canvas.h",
                                      "sheen_failure.h", "sheen_first_light.h", "sheen_i2c.h",    "sheen_linux_bus.h",
                                      "sheen_panel.h",   "sheen_pins.h",        "sheen_sender.h", "sheen_target.h",
                                      "sheen_version.h"};

    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) {
        if (strcasecmp(sheen_file_of(path), own[i]) == 0) /* some file systems ignore case */
            return 1;
    }
    return 0;
}
