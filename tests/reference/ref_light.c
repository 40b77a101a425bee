/*
 * ref_light.c - the lecture's illumination at a unit normal.
 *
 *   I_ambient_diffuse = Ia ka + sum Ip kd D(L.N), D(x) = max(0, x) or another ramp
 *   I_specular        = sum Ip ks max(0, R.V)^n min(1, 8 max(0, L.N))
 *   R.V = 2 (L.N)(N.V) - L.V, V = (0, 0, 1)
 */
#include "ref_vector.h"
#include "reference.h"

#define GAMMA 2.2

/* An entry of the table, x = i / 128 - 1. */
static double ramp_entry(const struct ref_scene *scene, int i)
{
    double x = 2.0 * i / REF_RAMP_STEPS - 1, lit = fmax(0, x), a = scene->ambient, d = scene->diffuse;

    switch (scene->ramp) {
    case REF_HALF:
        return (1 + x) / 2 * (1 + x) / 2;
    case REF_GAMMA:
        return (pow(a + d * lit, 1 / GAMMA) - a) / d;
    case REF_TOON: /* three steps, of a third each */
        return (lit > 0) / 3.0 + (lit > 0.25) / 3.0 + (lit > 0.7) / 3.0;
    default:
        return lit;
    }
}

double ref_ramp(const struct ref_scene *scene, double x)
{
    double at = (fmin(fmax(x, -1), 1) + 1) / 2 * REF_RAMP_STEPS;
    int i = (int)fmin(floor(at), REF_RAMP_STEPS - 1);

    return ramp_entry(scene, i) * (i + 1 - at) + ramp_entry(scene, i + 1) * (at - i);
}

void ref_light(const struct ref_scene *scene, const double normal[3], double *diffuse, double *specular)
{
    *diffuse = scene->ambient;
    *specular = 0;
    for (int i = 0; i < scene->light_count; i++) {
        double to[3] = {scene->light[i][0], scene->light[i][1], scene->light[i][2]};
        ref_normalize(to);

        double l_n = ref_dot(to, normal);
        if (normal[0] == 0 && normal[1] == 0 && normal[2] == 0)
            continue; /* ambient only */
        *diffuse += scene->diffuse * ref_ramp(scene, l_n);
        if (l_n <= 0)
            continue;
        double r_v = 2 * l_n * normal[2] - to[2];
        if (r_v > 0)
            *specular += scene->specular * pow(r_v, scene->shininess) * fmin(1, 8 * l_n);
    }
}
