/*
 * utf8.c - makes text from outside fit to be printed.
 */
#include "utf8.h"

#include <stdint.h>
#include <string.h>

#define KEEP 40 /* characters by which a long word, usually a path, can still be recognised */

static int is_inner(char byte)
{
    return ((unsigned char)byte & 0xc0) == 0x80;
}

/* Returns the code point; *bytes is the length as by sheen_utf8_bytes. */
static uint32_t decode(const char *text, size_t *bytes)
{
    static const uint32_t least[5] = {0, 1, 0x80, 0x800, 0x10000}; /* the least code point that needs so many bytes */
    unsigned char first = (unsigned char)*text;
    size_t count = first < 0x80 ? 1 : first < 0xc0 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf8 ? 4 : 0;
    uint32_t code = count < 2 ? first : first & (0x7fu >> count);

    for (size_t i = 1; i < count; i++) {
        if (!is_inner(text[i])) /* false for the '\0' too */
            count = 0;
        code = code << 6 | ((unsigned char)text[i] & 0x3f);
    }
    if (code < least[count] || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff))
        count = 0;
    *bytes = count;
    return code;
}

size_t sheen_utf8_bytes(const char *text)
{
    size_t bytes;

    (void)decode(text, &bytes);
    return bytes;
}

/* C0, DEL and C1 controls, separators of lines and paragraphs, and controls of the writing direction. */
static int is_control(uint32_t code)
{
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || (code >= 0x2028 && code <= 0x202e) ||
           (code >= 0x2066 && code <= 0x2069);
}

void sheen_utf8_clean(char *text)
{
    char *to = text; /* never ahead of text */

    while (*text) {
        size_t bytes;
        uint32_t code = decode(text, &bytes);
        if (bytes == 0 || is_control(code)) {
            *to++ = '?';
            text += bytes ? bytes : 1;
        } else {
            memmove(to, text, bytes);
            to += bytes;
            text += bytes;
        }
    }
    *to = '\0';
}

void sheen_utf8_copy(char *to, size_t size, const char *from)
{
    size_t length = strlen(from), fits = length < size ? length : size - 1;

    while (fits < length && fits > 0 && is_inner(from[fits]))
        fits--;
    memcpy(to, from, fits);
    to[fits] = '\0';
    sheen_utf8_clean(to);
}

/* ---- shortening clean text, in which every byte that is not an inner one begins a character ---- */

static size_t count_characters(const char *text, size_t bytes)
{
    size_t count = 0;

    for (size_t i = 0; i < bytes; i++)
        count += !is_inner(text[i]);
    return count;
}

static char *skip(char *text, size_t characters)
{
    for (; characters > 0; characters--)
        text += sheen_utf8_bytes(text);
    return text;
}

/* Finds the longest word; *longest is its number of characters. */
static char *find_longest(char *text, size_t *longest)
{
    char *found = text;

    *longest = 0;
    for (char *word = text; *word; word += strspn(word, " ")) {
        size_t bytes = strcspn(word, " "), count = count_characters(word, bytes);
        if (count > *longest) {
            *longest = count;
            found = word;
        }
        word += bytes;
    }
    return found;
}

/* Words keep more of their end, where a path has the file's name. If no word is long, the text is cut as a whole. */
void sheen_utf8_shorten(char *text, size_t most)
{
    size_t all;

    while ((all = count_characters(text, strlen(text))) > most) {
        size_t length, out = all - most + 3;
        char *word = find_longest(text, &length);
        if (length > KEEP + 3) {
            out = out < length - KEEP ? out : length - KEEP;
        } else {
            word = text;
            length = all;
        }
        char *begin = skip(word, (length - out) / 3), *end = skip(begin, out);
        memmove(begin + 3, end, strlen(end) + 1);
        memcpy(begin, "...", 3);
    }
}
