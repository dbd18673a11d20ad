/* A control shows what the scene has, or what the hand is about to make of it; a meter what is recorded at the time
 * that is shown. */
#include <glib/gi18n.h>
#include <math.h>

#include "gui/instrument/instrument-view-private.h"
#include "gui/instrument/meter-face.h"
#include "gui/instrument/value-entry.h"
#include "gui/text/number-text.h"
#include "gui/text/sentence.h"
#include "gui/text/translate.h"
#include "scene/store/quantities.h"

#define DIGITS  4
#define TELL_US 500000 /* at most so often is a value told to who hears it, while it plays */

const TinkerSceneInstrument *instrument_view_instrument(TinkerInstrumentView *view)
{
    GPtrArray *all = tinker_scene_instruments(tinker_document_scene(view->document));
    return view->number < (int)all->len ? g_ptr_array_index(all, (guint)view->number) : NULL;
}

static void tell(TinkerInstrumentView *view, const char *text)
{
    const gboolean playing = tinker_player_state(view->player) == TINKER_PLAYER_PLAYING;
    if (g_strcmp0(text, view->told_text) == 0 || (playing && g_get_monotonic_time() < view->told + TELL_US)) return;
    view->told = g_get_monotonic_time();
    g_free(view->told_text);
    view->told_text = g_strdup(text);
    gtk_accessible_update_property(GTK_ACCESSIBLE(view->part), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, text, -1);
    if (!tinker_instrument_controls(view->shown))
        gtk_accessible_update_property(GTK_ACCESSIBLE(view), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, text, -1);
}

static void show_text(TinkerInstrumentView *view, double si)
{
    g_autofree char *text = isnan(si) ? g_strdup("–") : tinker_number_measured(si, view->unit, DIGITS);
    if (GTK_IS_ENTRY(view->value))
        tinker_value_entry_show(view->value, text);
    else if (!g_str_equal(gtk_label_get_text(GTK_LABEL(view->value)), text))
        gtk_label_set_text(GTK_LABEL(view->value), text);
    tell(view, text);
}

/* The second number that went along, why, and what it was, as "Static Friction is never less, and goes along: 0.5 (was
 * 0.3)"; or NULL. */
static char *carried_text(TinkerInstrumentView *view)
{
    TinkerScene *scene = tinker_document_scene(view->document);
    const TinkerBlockId block = tinker_scene_find_block(scene, view->shown->block);
    TinkerCarried carried;
    if (block == TINKER_NO_BLOCK || !tinker_hand_carried(view->hand, block, view->shown->of, &carried)) return NULL;
    const TinkerPropertyType *type = &tinker_scene_block_class(scene, block)->properties[carried.property];
    g_autofree char *now = tinker_number_short(carried.now, view->unit, DIGITS),
                    *before = tinker_number_short(carried.before, view->unit, DIGITS);
    return g_strdup_printf(carried.now > carried.before ? _("%s is never less, and goes along: %s (was %s)")
                                                        : _("%s is never more, and goes along: %s (was %s)"),
                           tinker_translate(type->title), now, before);
}

void instrument_view_show_note(TinkerInstrumentView *view)
{
    if (gtk_widget_has_css_class(view->value, "error")) return;
    const double rate = tinker_hand_rate(view->hand);
    const char *problem = tinker_hand_problem(view->hand);
    const gboolean slow = rate > 0 && rate < TINKER_HAND_RUNS;
    g_autofree char *text = problem != NULL ? tinker_sentence(problem) : carried_text(view);
    if (text == NULL) text = slow ? g_strdup_printf(_("%.0f runs a second"), fmax(rate, 1)) : g_strdup("");
    gtk_label_set_text(GTK_LABEL(view->note), text);
    gtk_widget_set_visible(view->note, *text != '\0' && gtk_widget_has_css_class(GTK_WIDGET(view), "turned"));
}

static void show_control(TinkerInstrumentView *view)
{
    TinkerScene *scene = tinker_document_scene(view->document);
    const TinkerBlockId block = tinker_scene_find_block(scene, view->shown->block);
    TinkerNumber number;
    double value;
    if (block == TINKER_NO_BLOCK || !tinker_scene_find_number(scene, block, view->shown->of, &number)) return;
    if (!tinker_hand_wanted(view->hand, block, view->shown->of, &value))
        value = tinker_scene_get(scene, block, number.column);
    view->showing = TRUE;
    if (view->adjustment != NULL) gtk_adjustment_set_value(view->adjustment, value * view->per_si);
    if (GTK_IS_SWITCH(view->part)) gtk_switch_set_active(GTK_SWITCH(view->part), value > view->shown->from);
    view->showing = FALSE;
    if (number.type->kind == TINKER_KIND_SWITCH)
        gtk_label_set_text(GTK_LABEL(view->value), value != 0 ? _("On") : _("Off"));
    else
        show_text(view, value);
    instrument_view_show_note(view);
}

/* Takes in what has been recorded since. */
static void widen_range(TinkerInstrumentView *view, TinkerQuantity of)
{
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double)),
                      values = g_array_new(FALSE, FALSE, sizeof(double));
    const guint generation = tinker_player_generation(view->player);
    if (generation != view->generation) {
        view->cursor = (TinkerSeriesCursor){0};
        view->low = INFINITY;
        view->high = -INFINITY;
        view->generation = generation;
    }
    view->cursor.at_events = TRUE;
    tinker_player_series(view->player, of, &view->cursor, times, values);
    for (guint i = 0; i < values->len; i++) {
        const double value = g_array_index(values, double, i);
        if (!isfinite(value)) continue;
        view->low = fmin(view->low, value);
        view->high = fmax(view->high, value);
    }
}

static void show_meter(TinkerInstrumentView *view)
{
    TinkerScene *scene = tinker_document_scene(view->document);
    TinkerQuantity of;
    double value;
    if (!tinker_scene_find_owner(scene, view->shown->block, &of.block)) return;
    of.quantity = tinker_scene_find_quantity(scene, of.block, view->shown->of);
    if (of.quantity < 0) return;
    widen_range(view, of);
    if (!tinker_player_value(view->player, of.block, of.quantity, &value)) value = NAN;
    if (TINKER_IS_METER_FACE(view->part)) {
        if (view->low <= view->high)
            tinker_meter_face_set_range(TINKER_METER_FACE(view->part), view->low * view->per_si,
                                        view->high * view->per_si);
        tinker_meter_face_set_value(TINKER_METER_FACE(view->part), value * view->per_si);
    }
    show_text(view, value);
}

void instrument_view_show(TinkerInstrumentView *view)
{
    if (tinker_instrument_controls(view->shown))
        show_control(view);
    else
        show_meter(view);
}
