/* core_rules accepts */
#include <stdint.h>

/* Words such as double and malloc are allowed in comments. */
int32_t sheen_seed(int32_t half);

int32_t sheen_seed(int32_t half)
{
    return half * 2;
}
