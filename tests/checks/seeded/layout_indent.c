/* layout refuses: clang-format would change it */
int sheen_seed(int a);

int sheen_seed(int a) { return a; }
