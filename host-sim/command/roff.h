/*
 * roff.h - text into a page of the manual, on standard output.
 */
#ifndef SHEEN_ROFF_H
#define SHEEN_ROFF_H

/*
 * Text as it is, no hyphens of the typesetter's, nothing taken for a request or an escape, between roff: a request or a
 * font before it, the line's end or a font after it.
 */
void sheen_roff_line(const char *before, const char *text, const char *after);

#endif
