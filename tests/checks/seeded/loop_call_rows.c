/* freestanding refuses: bl sheen_seed_pixel */
#include <stdint.h>

uint16_t sheen_seed_pixel(int i);
void sheen_seed(uint16_t *to, int count);

__attribute__((noinline)) uint16_t sheen_seed_pixel(int i)
{
    return (uint16_t)(i ^ (i >> 3));
}

void sheen_seed(uint16_t *to, int count)
{
    for (int i = 0; i < count; i++) {
        to[i] = sheen_seed_pixel(i);
    }
}
