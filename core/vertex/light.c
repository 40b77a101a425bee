/*
 * light.c - ambient + diffuse + specular at a normal (lecture, "Illumination Models").
 *
 * Lights and the eye are turned into model space once per draw. Results are relative:
 * diffuse and specular in [0, 1] of what the draw's lights can give, so that 16 bits
 * hold them whatever the intensities; pixel/colour.c multiplies the intensities in.
 */
#include "vertex.h"

/* A matrix times v. Its rows are `row` numbers apart in memory, the parts of a row `part` numbers. */
static APART COLD void matrix_times(const sheen_q30_t *m, int row, int part, const int32_t v[3], int32_t out[3])
{
    for (int k = 0; k < 3; k++, m += row) {
        out[k] = 0;
        for (int i = 0; i < 3; i++)
            out[k] += sheen_mul_round(m[part * i], v[i], 30);
    }
}

/* R's rows are orthonormal, so its inverse is its transpose. */
void sheen_to_model(const sheen_q30_t r[9], const int32_t v[3], int32_t out[3])
{
    matrix_times(r, 1, 3, v, out);
}

/*
 * Intensities to weights, UQ1.15, that sum to at most 1.0. If the intensities sum to less
 * than 1/1000 the weights get coarse, but then no level can show it.
 */
static void weights(uint16_t weight[], const sheen_q16_t intensity[], unsigned count, sheen_q16_t sum)
{
    for (unsigned i = 0; i < count; i++)
        weight[i] = (uint16_t)(sum > 0 ? QUOTIENT((uint32_t)intensity[i] << 13, ((uint32_t)sum + 3) >> 2) : 0);
}

/* A light's direction in eye space. view: turns lights in the world there; NULL: world and eye space are one. */
static int eye_light(const struct sheen_light *light, const sheen_q30_t *view, enum lights_taken taken,
                     sheen_q30_t to[3])
{
    sheen_q30_t unit[3];

    if (light->intensity < 0 || light->intensity > 1 << 16 ||
        (uint32_t)light->radius > (taken == LIGHTS_ALL && light->points != NULL ? 1u << 26 : 0))
        return SHEEN_ERR_ARGUMENT;
    if (light->radius > 0) {
        to[0] = to[1] = to[2] = 0;
        return SHEEN_OK;
    }
    if (view == NULL || light->with_eye)
        return sheen_normalize(light->to, to);
    if (sheen_normalize(light->to, unit) < 0)
        return SHEEN_ERR_DEGENERATE;
    matrix_times(view, 3, 1, unit, to);
    return SHEEN_OK;
}

COLD int sheen_light_begin(struct lighting *l, const struct sheen_light *lights, unsigned count,
                           const sheen_q30_t rotation[9], const sheen_q30_t *view, enum lights_taken taken)
{
    const sheen_q30_t eye[3] = {0, 0, 1 << 30};
    sheen_q16_t diffuse[SHEEN_MAX_LIGHTS], specular[SHEEN_MAX_LIGHTS];

    if (count > SHEEN_MAX_LIGHTS || (count > 0 && lights == NULL))
        return SHEEN_ERR_ARGUMENT;
    sheen_to_model(rotation, eye, l->view);
    l->count = (uint8_t)count;
    l->ramp = NULL;
    l->diffuse_sum = 0;
    l->specular_sum = 0;
    for (unsigned i = 0; i < count; i++) {
        sheen_q30_t to[3];
        int error = eye_light(&lights[i], view, taken, to);
        if (error < 0)
            return error;
        sheen_to_model(rotation, to, l->to[i]);
        l->lv1[i] = (1 << 29) + to[2] / 2;
        diffuse[i] = lights[i].intensity != 0 ? lights[i].intensity : 1 << 16;
        specular[i] = lights[i].no_highlight ? 0 : diffuse[i];
        l->diffuse_sum += diffuse[i];
        l->specular_sum += specular[i];
    }
    weights(l->diffuse_weight, diffuse, count, l->diffuse_sum);
    weights(l->specular_weight, specular, count, l->specular_sum);
    return SHEEN_OK;
}

int32_t sheen_unit_cosine(const int16_t normal[3], int32_t lacks, const sheen_q30_t v[3])
{
    int32_t value = unit_dot_q29(normal, lacks, v);

    return 2 * min32(max32(value, -(1 << 29)), 1 << 29);
}

void sheen_light_plainly(const struct lighting *l, const struct power *power, const int16_t normal[3], struct lit *out)
{
    const int32_t lacks = lacking(normal), nv = sheen_unit_cosine(normal, lacks, l->view);
    uint32_t diffuse = 0, specular = 0; /* UQ2.30: weights sum to 1.0, so <= 2^30 */

    SHEEN_TAP(LIT, 1);
    SHEEN_TAP(LIGHT, l->count);
    for (unsigned i = 0; i < l->count; i++) {
        int32_t ln = sheen_unit_cosine(normal, lacks, l->to[i]);
        uint32_t rounded = ((uint32_t)ln + (1u << 14)) >> 15; /* UQ1.15 */
        if (ln <= 0)
            continue;
        diffuse += l->diffuse_weight[i] * rounded;
        /* 1 - R.V = (1 + L.V) - 2 (L.N)(N.V), Q2.29, of unrounded cosines, because s^n multiplies their error by n */
        int32_t u = (int32_t)((uint32_t)l->lv1[i] - (uint32_t)PRODUCT_FORM(cosines)(ln, nv));
        specular += l->specular_weight[i] * highlight_at(*power, u, rounded);
    }
    out->diffuse = (diffuse + (1u << 14)) >> 15;
    out->specular = (specular + (1u << 14)) >> 15;
}
