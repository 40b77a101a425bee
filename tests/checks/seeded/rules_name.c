/* core_rules refuses: the external name seed does not start with sheen_ */
int seed(void);

int seed(void)
{
    return 1;
}
