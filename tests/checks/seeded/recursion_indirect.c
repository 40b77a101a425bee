/* freestanding refuses: recursion: sheen_seed > __indirect_call */
struct seed {
    int (*next)(const struct seed *);
};
int sheen_seed(const struct seed *seed);

/* A cycle that no edge of the call graph shows, because the function calls itself through its address. */
const struct seed sheen_seed_self = {sheen_seed};

int sheen_seed(const struct seed *seed)
{
    return seed->next(seed) + 1;
}
