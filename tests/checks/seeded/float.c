/* freestanding refuses: refers to __aeabi_fmul */
float sheen_seed(float a, float b);

float sheen_seed(float a, float b)
{
    return a * b;
}
