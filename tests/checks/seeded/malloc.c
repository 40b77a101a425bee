/* freestanding refuses: refers to malloc */
#include <stddef.h>

void *malloc(size_t size);
void *sheen_seed(void);

void *sheen_seed(void)
{
    return malloc(8);
}
