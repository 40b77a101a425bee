/* core_rules refuses: recursion: sheen_seed > sheen_seed */
int sheen_seed(int count);

/* An optimising compiler turns this recursion into a loop; the check must see it all the same. */
int sheen_seed(int count)
{
    return count < 2 ? 1 : count * sheen_seed(count - 1);
}
