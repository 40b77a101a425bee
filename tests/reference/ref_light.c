/*
 * ref_light.c - the lecture's illumination at a unit normal.
 *
 *   I_ambient_diffuse = Ia ka + sum Ip kd D(L.N), D(x) = max(0, x) or another ramp
 *   I_specular        = sum Ip ks max(0, R.V)^n min(1, 8 max(0, L.N))
 *   R.V = 2 (L.N)(N.V) - L.V, V = (0, 0, 1)
 *
 * Each light's part and the ambient part are multiplied by their colour's channel. A point light at P lights a point p
 * at the distance d with L = (P - p) / d (L = N if d = 0); both its parts are multiplied by max(0, 1 - d^2 /
 * radius^2)^2.
 */
#include <string.h>

#include "ref_vector.h"
#include "reference.h"

#define GAMMA 2.2

/* Entry i of the ramp's table, for L.N = i / 128 - 1. */
static double ramp_entry(const struct ref_scene *scene, int i)
{
    double x = 2.0 * i / REF_RAMP_STEPS - 1, lit = ref_max(0, x), a = scene->ambient, d = scene->diffuse;

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
    double at = (ref_min(ref_max(x, -1), 1) + 1) / 2 * REF_RAMP_STEPS;
    int i = (int)ref_min(floor(at), REF_RAMP_STEPS - 1);

    return ramp_entry(scene, i) * (i + 1 - at) + ramp_entry(scene, i + 1) * (at - i);
}

/* Finds L of light i; returns the factor by which distance attenuates the light. */
static double to_light(const struct ref_scene *scene, int i, const double at[3], const double normal[3], double to[3])
{
    double radius = scene->radius[i];

    memcpy(to, scene->light[i], sizeof scene->light[i]);
    for (int k = 0; radius > 0 && k < 3; k++)
        to[k] += scene->translation[k] - at[k];
    double d = ref_normalize(to);
    if (radius <= 0)
        return 1;
    if (d == 0)
        memcpy(to, normal, sizeof scene->light[i]);
    double left = ref_max(0, 1 - d * d / (radius * radius));
    return left * left;
}

void ref_light(const struct ref_scene *scene, const double at[3], const double normal[3], struct ref_lit *lit)
{
    for (int k = 0; k < 3; k++) {
        lit->diffuse[k] = scene->ambient * scene->ambient_color[k];
        lit->specular[k] = 0;
    }
    for (int i = 0; i < scene->light_count; i++) {
        double to[3], left = to_light(scene, i, at, normal, to), l_n = ref_dot(to, normal);

        if (normal[0] == 0 && normal[1] == 0 && normal[2] == 0)
            continue; /* ambient only */
        double r_v = l_n <= 0 ? 0 : ref_max(0, 2 * l_n * normal[2] - to[2]);
        double ramp = ref_ramp(scene, l_n), shine = pow(r_v, scene->shininess), fade = ref_min(1, 8 * ref_max(0, l_n));
        for (int k = 0; k < 3; k++) {
            double color = left * scene->light_color[i][k];
            lit->diffuse[k] += color * scene->diffuse * ramp;
            lit->specular[k] += color * scene->specular * shine * fade;
        }
    }
}
