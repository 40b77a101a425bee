/*
 * roff.h - text of the manual page, escaped for roff, on standard output.
 */
#ifndef SHEEN_ROFF_H
#define SHEEN_ROFF_H

/*
 * Prints the text so that roff shows it as it is: '-' does not become a typographic hyphen, and nothing is taken for a
 * request or an escape. `before` and `after` are printed as roff: a request or a font, the line's end or a font.
 */
void sheen_roff_line(const char *before, const char *text, const char *after);

#endif
