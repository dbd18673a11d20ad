#include "common/graph/graph-names.h"

static char *full_name(const TinkerCurveName *curve)
{
    return curve->block[0] == '\0' ? g_strdup(curve->title) : g_strdup_printf("%s: %s", curve->block, curve->title);
}

static gboolean have_one_block(const TinkerCurveName *curves, guint count)
{
    for (guint i = 1; i < count; i++)
        if (!g_str_equal(curves[i].block, curves[0].block)) return FALSE;
    return TRUE;
}

/* Whether all are of one quantity, each of another block: what tells them apart is the block alone. */
static gboolean have_one_quantity(const TinkerCurveName *curves, guint count)
{
    for (guint i = 0; i < count; i++)
        if (curves[i].block[0] == '\0' || !g_str_equal(curves[i].title, curves[0].title)) return FALSE;
    return !have_one_block(curves, count);
}

char *tinker_curves_title(const TinkerCurveName *curves, guint count)
{
    const gboolean one_quantity = have_one_quantity(curves, count);
    GString *title = g_string_new(NULL);
    if (one_quantity) g_string_printf(title, "%s: ", curves[0].title);
    for (guint i = 0; i < count; i++) {
        g_autofree char *name = one_quantity ? g_strdup(curves[i].block)
                                : i == 0     ? full_name(curves)
                                             : tinker_curve_name(&curves[i], curves, count);
        g_string_append_printf(title, "%s%s", i > 0 ? ", " : "", name);
    }
    return g_string_free(title, FALSE);
}

char *tinker_curve_name(const TinkerCurveName *curve, const TinkerCurveName *curves, guint count)
{
    return have_one_block(curves, count) ? g_strdup(curve->title) : full_name(curve);
}

char *tinker_curve_legend(const TinkerCurveName *curve, const TinkerCurveName *curves, guint count)
{
    return have_one_quantity(curves, count) ? g_strdup(curve->block) : tinker_curve_name(curve, curves, count);
}
