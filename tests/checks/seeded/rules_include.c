/* core_rules refuses: includes stdio.h */
#include <stdio.h>

int sheen_seed(void);

int sheen_seed(void)
{
    return EOF;
}
