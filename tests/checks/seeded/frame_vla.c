/* freestanding refuses: sheen_seed: its stack frame has no fixed size */
#include <string.h>

int sheen_seed(int count);

int sheen_seed(int count)
{
    char bytes[count];

    memset(bytes, count, (unsigned)count);
    return bytes[count / 2];
}
