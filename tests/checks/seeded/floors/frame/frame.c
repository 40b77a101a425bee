#include "frame.h"

int sheen_seed_frame(int x)
{
    return x + 1;
}
