/* freestanding accepts */
#include <stdint.h>

uint16_t sheen_seed(uint16_t *to, uint32_t value, uint32_t step, int count);

uint16_t sheen_seed(uint16_t *to, uint32_t value, uint32_t step, int count)
{
    for (int i = 0; i < count; i++, value += step) {
        to[i] = (uint16_t)(value >> 16);
    }
    return count > 0 ? to[0] : 0;
}
