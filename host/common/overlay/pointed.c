/* A force is told from others by what it comes from, what it acts on, and of a contact by which of the two it is. */
#include "common/overlay/pointed.h"

#include <math.h>

TinkerPointed tinker_pointed_block(TinkerBlockId block)
{
    return (TinkerPointed){block, TINKER_NO_BLOCK, TINKER_POINTED_WHOLE};
}

gboolean tinker_pointed_is_force(const TinkerPointed *pointed)
{
    return pointed->block != TINKER_NO_BLOCK && pointed->on != TINKER_NO_BLOCK;
}

gboolean tinker_pointed_same(const TinkerPointed *a, const TinkerPointed *b)
{
    return a->block == b->block && a->on == b->on && a->part == b->part;
}

gboolean tinker_pointed_lights(const TinkerPointed *pointed, const TinkerPointed *thing)
{
    if (pointed == NULL || pointed->block == TINKER_NO_BLOCK || pointed->block != thing->block) return FALSE;
    const gboolean same_body =
        pointed->on == TINKER_NO_BLOCK || thing->on == TINKER_NO_BLOCK || pointed->on == thing->on;
    const gboolean same_part =
        pointed->part == TINKER_POINTED_WHOLE || thing->part == TINKER_POINTED_WHOLE || pointed->part == thing->part;
    return same_body && same_part;
}

/* Places ----------------------------------------------------------------------------------------------------------- */

static void spot_clear(gpointer data)
{
    g_free(((TinkerSpot *)data)->text);
}

GArray *tinker_spots_new(void)
{
    GArray *spots = g_array_new(FALSE, FALSE, sizeof(TinkerSpot));
    g_array_set_clear_func(spots, spot_clear);
    return spots;
}

static void add(GArray *spots, const double at[4], gboolean is_line, TinkerPointed what, const char *text)
{
    const TinkerSpot spot = {{at[0], at[1], at[2], at[3]}, is_line, what, g_strdup(text)};
    g_array_append_val(spots, spot);
}

void tinker_spots_add_box(GArray *spots, const double box[4], TinkerPointed what, const char *text)
{
    if (spots != NULL) add(spots, box, FALSE, what, text);
}

void tinker_spots_add_line(GArray *spots, const double ends[4], TinkerPointed what, const char *text)
{
    if (spots != NULL) add(spots, ends, TRUE, what, text);
}

void tinker_spots_move(GArray *spots, guint first, double dx, double dy)
{
    for (guint i = first; spots != NULL && i < spots->len; i++) {
        double *at = g_array_index(spots, TinkerSpot, i).at;
        at[0] += dx;
        at[1] += dy;
        at[2] += dx;
        at[3] += dy;
    }
}

static const TinkerSpot *spot_at(const GPtrArray *spots, int number)
{
    return g_ptr_array_index(spots, number);
}

const TinkerSpot *tinker_spots_next(const GArray *spots, const TinkerPointed *from, int step)
{
    g_autoptr(GPtrArray) things = g_ptr_array_new();
    int number = -1;
    for (guint i = 0; i < spots->len; i++) {
        TinkerSpot *spot = &g_array_index(spots, TinkerSpot, i);
        gboolean is_new = TRUE;
        for (int k = 0; k < (int)things->len && is_new; k++)
            is_new = !tinker_pointed_same(&spot_at(things, k)->what, &spot->what);
        if (!is_new) continue;
        if (from != NULL && tinker_pointed_same(&spot->what, from)) number = (int)things->len;
        g_ptr_array_add(things, spot);
    }
    if (things->len == 0) return NULL;
    return spot_at(things, number < 0 ? 0 : CLAMP(number + step, 0, (int)things->len - 1));
}

static double distance(const TinkerSpot *spot, double x, double y)
{
    const double *at = spot->at;
    if (!spot->is_line) return hypot(fmax(fmax(at[0] - x, x - at[2]), 0), fmax(fmax(at[1] - y, y - at[3]), 0));
    const double dx = at[2] - at[0], dy = at[3] - at[1], squared = dx * dx + dy * dy;
    const double share = squared > 0 ? fmin(fmax(((x - at[0]) * dx + (y - at[1]) * dy) / squared, 0), 1) : 0;
    return hypot(at[0] + share * dx - x, at[1] + share * dy - y);
}

const TinkerSpot *tinker_spots_at(const GArray *spots, double x, double y, double reach)
{
    const TinkerSpot *found = NULL;
    for (guint i = 0; i < spots->len; i++) {
        const TinkerSpot *spot = &g_array_index(spots, TinkerSpot, i);
        const double off = distance(spot, x, y);
        if (off > reach) continue;
        reach = off;
        found = spot;
    }
    return found;
}
