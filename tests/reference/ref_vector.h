/* ref_vector.h - arithmetic on one double and on three doubles, for the reference's stages. */
#ifndef REF_VECTOR_H
#define REF_VECTOR_H

#include <math.h>

/* fmin and fmax without a call, for arguments that are not NaN. */
static inline double ref_min(double a, double b)
{
    return a < b ? a : b;
}

static inline double ref_max(double a, double b)
{
    return a > b ? a : b;
}

static inline double ref_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double ref_length(const double a[3])
{
    return sqrt(ref_dot(a, a));
}

/* Scale a to unit length; a zero vector stays zero. Returns the length before. */
static inline double ref_normalize(double a[3])
{
    double length = ref_length(a);

    for (int k = 0; k < 3 && length > 0; k++)
        a[k] /= length;
    return length;
}

static inline void ref_cross(const double a[3], const double b[3], double out[3])
{
    double c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};

    for (int k = 0; k < 3; k++)
        out[k] = c[k];
}

static inline void ref_lerp(const double a[3], const double b[3], double t, double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = (1 - t) * a[k] + t * b[k];
}

#endif
