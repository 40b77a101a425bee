/* core_rules refuses: recursion: sheen_seed > sheen_seed */
int sheen_seed(int count);

/* An optimising compiler makes a loop of it, and must not hide it. */
int sheen_seed(int count)
{
    return count < 2 ? 1 : count * sheen_seed(count - 1);
}
