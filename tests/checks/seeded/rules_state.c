/* core_rules refuses: is mutable and outlives a call */
int sheen_seed(void);

int sheen_seed(void)
{
    static int last = 3;

    return last ^= 1;
}
