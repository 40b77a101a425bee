/* freestanding refuses: more than 1024: sheen_seed > sheen_seed_leaf > memset */
#include <string.h>

int sheen_seed_leaf(int value);
int sheen_seed(int value);

/* Each frame is below the limit, the chain is not. */
__attribute__((noinline)) int sheen_seed_leaf(int value)
{
    char bytes[600];

    memset(bytes, value, sizeof bytes);
    return bytes[value];
}

int sheen_seed(int value)
{
    char bytes[500];

    memset(bytes, value, sizeof bytes);
    return sheen_seed_leaf(bytes[value]) + bytes[value];
}
