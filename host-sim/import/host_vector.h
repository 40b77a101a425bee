/*
 * host_vector.h - three doubles. Private to host-sim.
 */
#ifndef SHEEN_HOST_VECTOR_H
#define SHEEN_HOST_VECTOR_H

#include <math.h>

/*
 * The nearest 32-bit float; -0 becomes 0. Volatile, because gcc 12.2 at -O2 omits the
 * conversion (double)(float)x when it computes two values at once.
 */
static inline double as_float(double x)
{
    volatile float nearest = (float)x;

    return (double)nearest + 0.0;
}

static inline double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross3(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/*
 * Normalises v and returns 1; returns 0 and leaves v unchanged if it is zero. v is first divided
 * by its largest component, so that squares neither underflow nor overflow.
 */
static inline int unit3(double v[3])
{
    double largest = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));

    if (!(largest > 0))
        return 0;
    double x = v[0] / largest, y = v[1] / largest, z = v[2] / largest, length = sqrt(x * x + y * y + z * z);
    v[0] = x / length;
    v[1] = y / length;
    v[2] = z / length;
    return 1;
}

#endif
