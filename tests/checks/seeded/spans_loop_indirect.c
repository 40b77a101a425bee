/* freestanding refuses: : blx r */
#include <stdint.h>

void sheen_seed(uint16_t *to, int count, uint16_t (*shade)(int i));

void sheen_seed(uint16_t *to, int count, uint16_t (*shade)(int i))
{
    for (int i = 0; i < count; i++) {
        to[i] = shade(i);
    }
}
