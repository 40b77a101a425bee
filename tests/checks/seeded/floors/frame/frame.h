/* The highest floor of a house whose every other file reaches where it must not. */
int sheen_seed_frame(int x);
