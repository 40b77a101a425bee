int sheen_seed_flat(int x);
int sheen_seed_phong(int x);

int sheen_seed_phong(int x)
{
    return sheen_seed_flat(x);
}
