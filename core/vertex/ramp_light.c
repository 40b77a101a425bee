/*
 * ramp_light.c - light at a normal where the material has a ramp: the dark side has diffuse light of its own.
 */
#include "light.h"

void sheen_light_by_ramp(const struct lighting *l, struct power power, const int16_t normal[3], struct lit *out)
{
    int32_t lacks = lacking(normal), nv = unit_cosine(normal, lacks, l->view);
    uint32_t diffuse = 0, specular = 0; /* UQ2.30: weights sum to 1.0, so <= 2^30 and, were a ramp wrong, 2^31 */

    for (unsigned i = 0; i < l->count && (normal[0] | normal[1] | normal[2]) != 0; i++) {
        int32_t ln = unit_cosine(normal, lacks, l->to[i]);
        diffuse += l->diffuse_weight[i] * response_at(l->ramp, asr32(ln + (1 << 14), 15));
        if (ln > 0)
            specular += l->specular_weight[i] * reflected_light(l, i, power, ln, nv);
    }
    diffuse = (diffuse + (1u << 14)) >> 15;
    out->diffuse = diffuse < 32768 ? diffuse : 32768;
    out->specular = (specular + (1u << 14)) >> 15;
}
