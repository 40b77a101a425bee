int sheen_seed_frame(int x);
int sheen_seed_pixel(int x);

int sheen_seed_pixel(int x)
{
    return sheen_seed_frame(x);
}
