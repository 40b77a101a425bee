/* core_rules refuses: rules_double.c:3: double */
int sheen_seed(int a);
static const double half = 0.5; /* folded by the compiler, so that no object shows it */

int sheen_seed(int a)
{
    return (int)(a * half);
}
