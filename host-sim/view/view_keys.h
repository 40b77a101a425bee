/*
 * view_keys.h - the keys of `sheen view`, for its help: one line per key, the last without newline.
 */
#ifndef SHEEN_VIEW_KEYS_H
#define SHEEN_VIEW_KEYS_H

#define SHEEN_VIEW_KEYS                                                                                                \
    "  space       stop, go on\n"                                                                                      \
    "  n           stop; the next frame\n"                                                                             \
    "  b           stop; the next band, as the bus sends it\n"                                                         \
    "  arrows      turn and tilt the mesh\n"                                                                           \
    "  s           shading: flat, gouraud, phong, slerp, matcap, matcap-vertex\n"                                      \
    "  l           turn the lights by 30 degrees\n"                                                                    \
    "  d           dither on, off\n"                                                                                   \
    "  e           edges: smooth, outline, wire, none\n"                                                               \
    "  a           shading linear in space, or linear on the screen\n"                                                 \
    "  o           perspective or orthographic\n"                                                                      \
    "  r           the next orientation\n"                                                                             \
    "  p, P        the next panel, the previous one\n"                                                                 \
    "  t           theme: lcd, oled, blue, ...\n"                                                                      \
    "  +, -        scale\n"                                                                                            \
    "  x           gap between the pixels\n"                                                                           \
    "  w           write sheen-NNN.png\n"                                                                              \
    "  g           start or end recording sheen-NNN.gif\n"                                                             \
    "  q, Esc      quit"

#endif
