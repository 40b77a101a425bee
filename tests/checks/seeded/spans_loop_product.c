/* freestanding refuses: umull */
#include <stdint.h>

uint32_t sheen_seed(const uint32_t *from, int count, uint32_t scale);

uint32_t sheen_seed(const uint32_t *from, int count, uint32_t scale)
{
    uint32_t sum = 0;

    while (count-- > 0) {
        sum += (uint32_t)(((uint64_t)from[count] * scale) >> 32);
    }
    return sum;
}
