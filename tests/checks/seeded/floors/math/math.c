int sheen_seed_math(int x);

int sheen_seed_math(int x)
{
    return x;
}
