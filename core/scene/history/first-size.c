/* On a canvas of 30 cm a support of 4 m is all that is seen, and on one of 200 m a box of 0.8 m is a dot. */
#include "scene/history/first-size.h"

#include <math.h>

#include "units/quantity/point-text.h"

#define ORDINARY_WIDTH 10.0 /* m: of the scene that the sizes of types are meant for */

/* 1, 2 or 5 times a power of ten: which is nearest by ratio. */
static double round_factor(double factor)
{
    static const double steps[] = {1, 2, 5, 10};
    const double power = pow(10, floor(log10(factor)));
    double best = power;
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++)
        if (fabs(log(factor / (steps[i] * power))) < fabs(log(factor / best))) best = steps[i] * power;
    return best;
}

static void scale_number(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, int meaning, double factor)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    if (block_class->meanings[meaning] < 0) return;
    const double size =
        factor * tinker_scene_get(scene, block, tinker_block_class_meaning_column(block_class, meaning));
    if (size > 0) tinker_history_set(history, block, block_class->meanings[meaning], &size, NULL);
}

/* Corners, about the origin of the axes that they are told in. */
static void scale_points(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, int32_t property,
                         double factor)
{
    const TinkerPropertyType *type = &tinker_scene_block_class(scene, block)->properties[property];
    g_autoptr(GArray) points =
        tinker_point_text_parse(tinker_scene_get_text(scene, block, property), type->dimension, NULL);
    if (points == NULL) return;
    for (guint i = 0; i < points->len; i++)
        g_array_index(points, double, i) *= factor;
    g_autofree char *text = tinker_point_text_new((const double *)(const void *)points->data, (int32_t)points->len / 2);
    tinker_history_set_text(history, block, property, text);
}

void tinker_first_size(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block)
{
    static const TinkerDimension length = TINKER_DIMENSION_LENGTH;
    static const int sizes[] = {TINKER_MEANING_WIDTH, TINKER_MEANING_HEIGHT, TINKER_MEANING_RADIUS};
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    const double width = tinker_scene_head(scene)->canvas_width;
    if (block_class == NULL || !(width > 0) || !isfinite(width)) return;
    const double factor = round_factor(width / ORDINARY_WIDTH);
    if (factor == 1) return;
    for (gsize i = 0; i < G_N_ELEMENTS(sizes); i++)
        scale_number(history, scene, block, sizes[i], factor);
    for (int32_t p = 0; p < block_class->property_count; p++)
        if ((block_class->properties[p].flags & TINKER_TEXT_POINTS) != 0 &&
            tinker_dimension_equal(block_class->properties[p].dimension, length))
            scale_points(history, scene, block, p, factor);
}
