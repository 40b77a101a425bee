/* core_rules refuses: [-Werror=vla] */
int sheen_seed(int count);

int sheen_seed(int count)
{
    int values[count];

    values[0] = count;
    return values[0];
}
