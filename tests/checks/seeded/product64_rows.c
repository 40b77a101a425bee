/* freestanding refuses: sheen_seed calls __aeabi_lmul */
#include <stdint.h>

int32_t sheen_seed(int32_t a, int32_t b);

int32_t sheen_seed(int32_t a, int32_t b)
{
    return (int32_t)(((int64_t)a * b) >> 16);
}
