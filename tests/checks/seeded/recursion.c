/* freestanding refuses: recursion: sheen_seed > sheen_seed */
int sheen_seed(const int *tree, int node);

int sheen_seed(const int *tree, int node)
{
    return node < 0 ? 0 : sheen_seed(tree, tree[2 * node]) + sheen_seed(tree, tree[2 * node + 1]) * node;
}
