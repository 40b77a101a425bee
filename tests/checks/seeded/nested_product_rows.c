/* freestanding refuses: M3: tests/checks/seeded/nested_product_rows.c: sheen_seed, pixel loop at */
#include <stdint.h>

void sheen_seed(uint32_t *to, int count, uint32_t scale);

/* Because of the loop over bits inside it, the loop over pixels is not an innermost one. */
void sheen_seed(uint32_t *to, int count, uint32_t scale)
{
    for (int i = 0; i < count; i++) {
        uint32_t value = to[i] | 1u;

        while (value < 0x80000000u) {
            value <<= 1;
        }
        to[i] = (uint32_t)(((uint64_t)value * scale) >> 32);
    }
}
