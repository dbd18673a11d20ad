/* Turning a control, or typing its number: the hand sets what the scene has. */
#include <math.h>

#include "gui/instrument/instrument-edit.h"
#include "gui/instrument/instrument-view-private.h"
#include "gui/text/number-text.h"
#include "gui/text/sentence.h"
#include "scene/store/quantities.h"

/* The step that is nearest, as it would be typed: 0.3 and not three times 0.1. */
static double at_step(const TinkerSceneInstrument *control, double si)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE];
    const double nearest = control->from + control->step * round((si - control->from) / control->step);
    return g_ascii_strtod(g_ascii_formatd(text, sizeof text, "%.12g", nearest), NULL);
}

static void turn_to(TinkerInstrumentView *view, double si)
{
    const TinkerSceneInstrument *control = instrument_view_instrument(view);
    if (view->showing || control == NULL) return;
    TinkerScene *scene = tinker_document_scene(view->document);
    const TinkerBlockId block = tinker_scene_find_block(scene, control->block);
    if (control->step > 0) si = at_step(control, si);
    gtk_widget_add_css_class(GTK_WIDGET(view), "turned");
    if (block != TINKER_NO_BLOCK)
        tinker_hand_set(view->hand, block, control->of, CLAMP(si, control->from, control->to));
    instrument_view_show(view);
}

void instrument_view_on_value_changed(GtkAdjustment *adjustment, TinkerInstrumentView *view)
{
    turn_to(view, gtk_adjustment_get_value(adjustment) / view->per_si);
}

void instrument_view_on_switched(GtkSwitch *widget, GParamSpec *spec, TinkerInstrumentView *view)
{
    turn_to(view, gtk_switch_get_active(widget) ? view->shown->to : view->shown->from);
    if (!view->showing) tinker_hand_let_go(view->hand);
}

static gboolean on_event(GtkEventControllerLegacy *controller, GdkEvent *event, TinkerInstrumentView *view)
{
    const GdkEventType type = gdk_event_get_event_type(event);
    if (type == GDK_BUTTON_PRESS || type == GDK_KEY_RELEASE) tinker_hand_let_go(view->hand);
    return GDK_EVENT_PROPAGATE;
}

void instrument_view_hear_release(TinkerInstrumentView *view)
{
    GtkEventController *events = gtk_event_controller_legacy_new();
    gtk_event_controller_set_propagation_phase(events, GTK_PHASE_CAPTURE);
    g_signal_connect(events, "event", G_CALLBACK(on_event), view);
    gtk_widget_add_controller(GTK_WIDGET(view), events);
}

static void show_problem(TinkerInstrumentView *view, const char *problem)
{
    g_autofree char *sentence = tinker_sentence(problem);
    gtk_label_set_text(GTK_LABEL(view->note), sentence);
    gtk_widget_set_visible(view->note, TRUE);
}

gboolean instrument_view_take_typed(const char *text, gpointer data)
{
    TinkerInstrumentView *view = data;
    const TinkerSceneInstrument *control = instrument_view_instrument(view);
    TinkerScene *scene = tinker_document_scene(view->document);
    const TinkerBlockId block = control != NULL ? tinker_scene_find_block(scene, control->block) : TINKER_NO_BLOCK;
    g_autoptr(GError) error = NULL;
    TinkerNumber number;
    double si;
    if (block == TINKER_NO_BLOCK || !tinker_scene_find_number(scene, block, control->of, &number)) return TRUE;
    if (!tinker_number_read(text, number.type->dimension, view->unit, &si, &error)) {
        show_problem(view, error->message);
        return FALSE;
    }
    const double from = fmin(control->from, si), to = fmax(control->to, si), step = control->step;
    tinker_hand_set(view->hand, block, control->of, si);
    tinker_hand_let_go(view->hand);
    if (tinker_hand_problem(view->hand) != NULL) {
        show_problem(view, tinker_hand_problem(view->hand));
        return FALSE;
    }
    gtk_widget_add_css_class(GTK_WIDGET(view), "turned");
    instrument_view_show(view);
    if (from < view->shown->from || to > view->shown->to)
        tinker_instrument_set_range(view->document, view->number, from, to, step, NULL);
    return TRUE;
}
