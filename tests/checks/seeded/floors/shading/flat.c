#include "../frame/frame.h"

int sheen_seed_flat(int x);

int sheen_seed_flat(int x)
{
    return x;
}
