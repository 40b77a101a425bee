/* freestanding refuses: 4 B of mutable state: count */
int sheen_seed(void);

int sheen_seed(void)
{
    static int count;

    return count++;
}
