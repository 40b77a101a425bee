/* The topmost folder of a core in which pixel.c, flat.c and phong.c use something that they must not. */
int sheen_seed_frame(int x);
