/*
 * ref_light.c - the lecture's illumination at a unit normal.
 *
 *   I_ambient_diffuse = Ia ka + sum Ip kd max(0, L.N)
 *   I_specular        = sum Ip ks max(0, R.V)^n min(1, 8 max(0, L.N))
 *   R.V = 2 (L.N)(N.V) - L.V, V = (0, 0, 1)
 */
#include "ref_vector.h"
#include "reference.h"

void ref_light(const struct ref_scene *scene, const double normal[3], double *diffuse, double *specular)
{
    *diffuse = scene->ambient;
    *specular = 0;
    for (int i = 0; i < scene->light_count; i++) {
        double to[3] = {scene->light[i][0], scene->light[i][1], scene->light[i][2]};
        ref_normalize(to);

        double l_n = ref_dot(to, normal);
        if (l_n <= 0)
            continue; /* also a normal of length zero: ambient only */
        double r_v = 2 * l_n * normal[2] - to[2];
        *diffuse += scene->diffuse * l_n;
        if (r_v > 0)
            *specular += scene->specular * pow(r_v, scene->shininess) * fmin(1, 8 * l_n);
    }
}
