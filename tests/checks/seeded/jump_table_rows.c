/* freestanding refuses: sheen_seed, pixel loop at */
#include <stdint.h>

int32_t sheen_seed(const int32_t *from, int count);

/* The division is in a case that only a jump table leads to. */
int32_t sheen_seed(const int32_t *from, int count)
{
    int32_t sum = 0;

    for (int i = 0; i < count; i++) {
        switch (from[i]) {
        case 0:
            sum += 7;
            break;
        case 1:
            sum *= 3;
            break;
        case 2:
            sum -= 4;
            break;
        case 3:
            sum ^= 5;
            break;
        case 4:
            sum |= 8;
            break;
        case 5:
            sum /= count;
            break;
        default:
            sum = -sum;
        }
    }
    return sum;
}
