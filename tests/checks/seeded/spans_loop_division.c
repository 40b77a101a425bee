/* freestanding refuses: M3: tests/checks/seeded/spans_loop_division.c: sheen_seed, pixel loop at */
#include <stdint.h>

uint32_t sheen_seed(const uint32_t *from, int rows, int count);

/* The loop over rows contains another loop, so only the inner one counts as a pixel loop. */
uint32_t sheen_seed(const uint32_t *from, int rows, int count)
{
    uint32_t sum = 0;

    for (int row = 1; row <= rows; row++) {
        for (int i = 0; i < count; i++) {
            if (from[i] > 9) {
                sum += from[i] / (uint32_t)row;
            }
        }
    }
    return sum;
}
