/*
 * ramp_light.c - diffuse light at a normal if the material has a ramp, which may light the dark side too.
 */
#include "vertex.h"

void sheen_light_by_ramp(const struct lighting *l, const struct power *power, const int16_t normal[3], struct lit *out)
{
    const int32_t lacks = lacking(normal);
    uint32_t diffuse = 0; /* UQ2.30: weights sum to 1.0, so <= 2^30, and with an invalid ramp <= 2^31 */

    SHEEN_TAP(RAMP_LIGHT, l->count);
    for (unsigned i = 0; i < l->count && (normal[0] | normal[1] | normal[2]) != 0; i++) {
        const int32_t ln = sheen_unit_cosine(normal, lacks, l->to[i]);
        diffuse += l->diffuse_weight[i] * response_at(l->ramp, asr32(ln + (1 << 14), 15));
    }
    sheen_light_plainly(l, power, normal, out);
    diffuse = (diffuse + (1u << 14)) >> 15;
    out->diffuse = diffuse < 32768 ? diffuse : 32768;
}
