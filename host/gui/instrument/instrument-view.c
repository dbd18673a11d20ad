/* A control shows what the scene has, or what the hand is about to make of it; a meter what is recorded at the time
 * that is shown. */
#include "gui/instrument/instrument-view.h"

#include <glib/gi18n.h>
#include <math.h>

#include "gui/instrument/instrument-edit.h"
#include "gui/instrument/instrument-range.h"
#include "gui/instrument/knob.h"
#include "gui/instrument/meter-face.h"
#include "gui/instrument/value-entry.h"
#include "gui/text/number-text.h"
#include "gui/text/sentence.h"
#include "gui/text/translate.h"
#include "gui/widget/popup-menu.h"
#include "gui/widget/unparent.h"
#include "scene/store/quantities.h"

#define DIGITS      4
#define STEPS       100.0 /* of a range without steps, by key */
#define SCALE_WIDTH 170
#define TELL_US     500000 /* at most so often is a value told to who hears it, while it plays */

struct _TinkerInstrumentView {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    TinkerHand *hand; /* borrowed */
    int number;
    TinkerSceneInstrument *shown; /* as it was when the parts were made */
    double per_si;                /* what is shown of 1 in SI */
    const char *unit;
    gboolean showing; /* changes of the parts are ours */
    GtkAdjustment *adjustment;
    GtkWidget *bar, *title, *part, *value, *note;
    gint64 told; /* us: when a value was told last, */
    char *told_text;

    /* Of a meter: the range of what has been recorded. */
    guint generation;
    TinkerSeriesCursor cursor;
    double low, high;
};

G_DEFINE_FINAL_TYPE(TinkerInstrumentView, tinker_instrument_view, GTK_TYPE_WIDGET)

static const TinkerSceneInstrument *instrument_of(TinkerInstrumentView *view)
{
    GPtrArray *all = tinker_scene_instruments(tinker_document_scene(view->document));
    return view->number < (int)all->len ? g_ptr_array_index(all, (guint)view->number) : NULL;
}

/* Values ----------------------------------------------------------------------------------------------------------- */

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

/* Why there is no run; what else was changed; or how many runs a second there is time for, where these are so few that
 * one sees it. What is wrong with a number that was typed stays as long as that number does. */
static void show_note(TinkerInstrumentView *view)
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
    show_note(view);
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

static void show(TinkerInstrumentView *view)
{
    if (tinker_instrument_controls(view->shown))
        show_control(view);
    else
        show_meter(view);
}

/* Turning ---------------------------------------------------------------------------------------------------------- */

/* The step that is nearest, as it would be typed: 0.3 and not three times 0.1. */
static double at_step(const TinkerSceneInstrument *control, double si)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE];
    const double nearest = control->from + control->step * round((si - control->from) / control->step);
    return g_ascii_strtod(g_ascii_formatd(text, sizeof text, "%.12g", nearest), NULL);
}

static void turn_to(TinkerInstrumentView *view, double si)
{
    const TinkerSceneInstrument *control = instrument_of(view);
    if (view->showing || control == NULL) return;
    TinkerScene *scene = tinker_document_scene(view->document);
    const TinkerBlockId block = tinker_scene_find_block(scene, control->block);
    if (control->step > 0) si = at_step(control, si);
    gtk_widget_add_css_class(GTK_WIDGET(view), "turned");
    if (block != TINKER_NO_BLOCK)
        tinker_hand_set(view->hand, block, control->of, CLAMP(si, control->from, control->to));
    show(view);
}

static void on_value_changed(GtkAdjustment *adjustment, TinkerInstrumentView *view)
{
    turn_to(view, gtk_adjustment_get_value(adjustment) / view->per_si);
}

static void on_switched(GtkSwitch *widget, GParamSpec *spec, TinkerInstrumentView *view)
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

static void show_problem(TinkerInstrumentView *view, const char *problem)
{
    g_autofree char *sentence = tinker_sentence(problem);
    gtk_label_set_text(GTK_LABEL(view->note), sentence);
    gtk_widget_set_visible(view->note, TRUE);
}

/* Exactly that number, and the range is widened where it has to be. */
static gboolean take_typed(const char *text, gpointer data)
{
    TinkerInstrumentView *view = data;
    const TinkerSceneInstrument *control = instrument_of(view);
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
    show(view);
    if (from < view->shown->from || to > view->shown->to)
        tinker_instrument_set_range(view->document, view->number, from, to, step, NULL);
    return TRUE;
}

/* Parts ------------------------------------------------------------------------------------------------------------ */

static GtkWidget *turned_part(TinkerInstrumentView *view)
{
    const double from = view->shown->from * view->per_si, to = view->shown->to * view->per_si;
    const double step = view->shown->step > 0 ? view->shown->step * view->per_si : (to - from) / STEPS;
    view->adjustment = g_object_ref_sink(gtk_adjustment_new(from, from, to, step, 10 * step, 0));
    g_signal_connect_object(view->adjustment, "value-changed", G_CALLBACK(on_value_changed), view, 0);
    if (view->shown->kind == TINKER_INSTRUMENT_KNOB) return tinker_knob_new(view->adjustment);
    GtkWidget *scale = gtk_scale_new(GTK_ORIENTATION_HORIZONTAL, view->adjustment);
    gtk_widget_set_size_request(scale, SCALE_WIDTH, -1);
    return scale;
}

static GtkWidget *part_new(TinkerInstrumentView *view)
{
    switch (view->shown->kind) {
    case TINKER_INSTRUMENT_SLIDER:
    case TINKER_INSTRUMENT_KNOB:
        return turned_part(view);
    case TINKER_INSTRUMENT_SWITCH: {
        GtkWidget *part = gtk_switch_new();
        g_signal_connect_object(part, "notify::active", G_CALLBACK(on_switched), view, 0);
        return part;
    }
    case TINKER_INSTRUMENT_DIAL:
    case TINKER_INSTRUMENT_BAR:
        return tinker_meter_face_new(view->shown->kind == TINKER_INSTRUMENT_DIAL);
    default:
        return gtk_label_new(NULL); /* whose text is the value */
    }
}

static double per_si_of(const char *unit)
{
    TinkerUnit read = {1, {0, 0, 0, 0}};
    tinker_unit_parse(unit, &read, NULL);
    return 1 / read.factor;
}

static void add_parts(TinkerInstrumentView *view)
{
    const gboolean is_number = view->shown->kind == TINKER_INSTRUMENT_NUMBER;
    g_autofree char *title = tinker_instrument_title(tinker_document_scene(view->document), view->shown);
    view->part = part_new(view);
    gtk_widget_set_halign(view->part, GTK_ALIGN_CENTER);
    gtk_widget_set_parent(view->part, GTK_WIDGET(view));
    const gboolean is_typed = view->adjustment != NULL;
    view->value = is_number ? view->part : is_typed ? tinker_value_entry_new(take_typed, view) : gtk_label_new(NULL);
    gtk_widget_add_css_class(view->value, is_number ? "instrument-number" : "instrument-value");
    if (!is_number) gtk_widget_set_parent(view->value, GTK_WIDGET(view));
    view->note = g_object_new(GTK_TYPE_LABEL, "visible", FALSE, "wrap", TRUE, "max-width-chars", 24, NULL);
    gtk_widget_add_css_class(view->note, "dim-label");
    gtk_widget_set_parent(view->note, GTK_WIDGET(view));
    gtk_label_set_text(GTK_LABEL(view->title), title);
    gtk_widget_set_tooltip_text(view->title, title);
    if (!is_number)
        gtk_accessible_update_property(GTK_ACCESSIBLE(view->part), GTK_ACCESSIBLE_PROPERTY_LABEL, title, -1);
    g_autofree char *value_label = g_strdup_printf(_("Value of %s"), title);
    if (is_typed) g_signal_connect_swapped(view->value, "notify::css-classes", G_CALLBACK(show_note), view);
    if (is_typed)
        gtk_accessible_update_property(GTK_ACCESSIBLE(view->value), GTK_ACCESSIBLE_PROPERTY_LABEL, value_label, -1);
    g_autofree char *label =
        g_strdup_printf(tinker_instrument_controls(view->shown) ? _("Control of %s") : _("Meter of %s"), title);
    gtk_accessible_update_property(GTK_ACCESSIBLE(view), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
}

static gboolean same_parts(const TinkerSceneInstrument *a, const TinkerSceneInstrument *b)
{
    return a->kind == b->kind && a->from == b->from && a->to == b->to && a->step == b->step &&
           g_str_equal(a->block, b->block) && g_str_equal(a->of, b->of);
}

gboolean tinker_instrument_view_fits(TinkerInstrumentView *view, const TinkerSceneInstrument *instrument)
{
    return same_parts(view->shown, instrument) &&
           view->unit == tinker_instrument_unit(tinker_document_scene(view->document), instrument);
}

void tinker_instrument_view_set_number(TinkerInstrumentView *view, int number)
{
    view->number = number;
    show(view);
}

int tinker_instrument_view_number(TinkerInstrumentView *view)
{
    return view->number;
}

GtkWidget *tinker_instrument_view_bar(TinkerInstrumentView *view)
{
    return view->bar;
}

/* Commands --------------------------------------------------------------------------------------------------------- */

static void delete_instrument(GtkWidget *widget, const char *name, GVariant *parameter)
{
    TinkerInstrumentView *view = TINKER_INSTRUMENT_VIEW(widget);
    tinker_instrument_remove(view->document, view->number);
}

static void set_kind(GtkWidget *widget, const char *name, GVariant *parameter)
{
    TinkerInstrumentView *view = TINKER_INSTRUMENT_VIEW(widget);
    tinker_instrument_set_kind(view->document, view->number, (TinkerInstrumentKind)g_variant_get_int32(parameter));
}

static void set_range(GtkWidget *widget, const char *name, GVariant *parameter)
{
    TinkerInstrumentView *view = TINKER_INSTRUMENT_VIEW(widget);
    tinker_instrument_range_popup(widget, view->document, view->number);
}

static GMenu *menu_of(TinkerInstrumentView *view)
{
    const gboolean controls = tinker_instrument_controls(view->shown);
    GMenu *menu = g_menu_new();
    g_autoptr(GMenu) kinds = g_menu_new(), others = g_menu_new();
    for (int i = 0; i < 3; i++) {
        const TinkerInstrumentKind kind =
            (TinkerInstrumentKind)(i + (controls ? TINKER_INSTRUMENT_SLIDER : TINKER_INSTRUMENT_NUMBER));
        g_autoptr(GMenuItem) item = g_menu_item_new(tinker_instrument_kind_title(kind), NULL);
        g_menu_item_set_action_and_target_value(item, "instrument.kind", g_variant_new_int32((gint32)kind));
        g_menu_append_item(kinds, item);
    }
    g_menu_append_section(menu, NULL, G_MENU_MODEL(kinds));
    if (controls) g_menu_append(others, _("Set _Range…"), "instrument.range");
    g_menu_append(others, controls ? _("_Delete Control") : _("_Delete Meter"), "instrument.delete");
    g_menu_append_section(menu, NULL, G_MENU_MODEL(others));
    return menu;
}

static void popup(GtkWidget *widget, double x, double y)
{
    g_autoptr(GMenu) menu = menu_of(TINKER_INSTRUMENT_VIEW(widget));
    tinker_popup_menu(widget, G_MENU_MODEL(menu), x, y);
}

static void show_menu(GtkWidget *widget, const char *name, GVariant *parameter)
{
    popup(widget, 12, gtk_widget_get_height(TINKER_INSTRUMENT_VIEW(widget)->bar));
}

static void on_menu(GtkGestureClick *gesture, int presses, double x, double y, GtkWidget *view)
{
    gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_CLAIMED);
    gtk_widget_grab_focus(view);
    popup(view, x, y);
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static void tinker_instrument_view_dispose(GObject *object)
{
    TinkerInstrumentView *view = TINKER_INSTRUMENT_VIEW(object);
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_object(&view->adjustment);
    g_clear_pointer(&view->shown, tinker_scene_instrument_free);
    g_clear_pointer(&view->told_text, g_free);
    g_clear_object(&view->player);
    g_clear_object(&view->document);
    G_OBJECT_CLASS(tinker_instrument_view_parent_class)->dispose(object);
}

static void tinker_instrument_view_class_init(TinkerInstrumentViewClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = tinker_instrument_view_dispose;
    gtk_widget_class_set_layout_manager_type(widget_class, GTK_TYPE_BOX_LAYOUT);
    gtk_widget_class_set_css_name(widget_class, "instrument");
    gtk_widget_class_set_accessible_role(widget_class, GTK_ACCESSIBLE_ROLE_GROUP);
    gtk_widget_class_install_action(widget_class, "instrument.delete", NULL, delete_instrument);
    gtk_widget_class_install_action(widget_class, "instrument.kind", "i", set_kind);
    gtk_widget_class_install_action(widget_class, "instrument.range", NULL, set_range);
    gtk_widget_class_install_action(widget_class, "instrument.menu", NULL, show_menu);
    gtk_widget_class_add_binding_action(widget_class, GDK_KEY_Delete, 0, "instrument.delete", NULL);
    gtk_widget_class_add_binding_action(widget_class, GDK_KEY_Menu, 0, "instrument.menu", NULL);
    gtk_widget_class_add_binding_action(widget_class, GDK_KEY_F10, GDK_SHIFT_MASK, "instrument.menu", NULL);
}

static void tinker_instrument_view_init(TinkerInstrumentView *view)
{
    gtk_orientable_set_orientation(GTK_ORIENTABLE(gtk_widget_get_layout_manager(GTK_WIDGET(view))),
                                   GTK_ORIENTATION_VERTICAL);
    gtk_widget_set_focusable(GTK_WIDGET(view), TRUE);
    view->bar = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 4);
    view->title = gtk_label_new(NULL);
    gtk_label_set_wrap(GTK_LABEL(view->title), TRUE);
    gtk_label_set_wrap_mode(GTK_LABEL(view->title), PANGO_WRAP_WORD_CHAR);
    gtk_label_set_xalign(GTK_LABEL(view->title), 0.5);
    gtk_label_set_max_width_chars(GTK_LABEL(view->title), 26);
    gtk_label_set_lines(GTK_LABEL(view->title), 2);
    gtk_label_set_ellipsize(GTK_LABEL(view->title), PANGO_ELLIPSIZE_MIDDLE);
    gtk_widget_add_css_class(view->title, "instrument-title");
    gtk_widget_set_hexpand(view->title, TRUE);
    gtk_box_append(GTK_BOX(view->bar), view->title);
    gtk_widget_set_cursor_from_name(view->bar, "grab");
    gtk_widget_set_parent(view->bar, GTK_WIDGET(view));
    GtkGesture *click = gtk_gesture_click_new();
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(click), GDK_BUTTON_SECONDARY);
    gtk_event_controller_set_propagation_phase(GTK_EVENT_CONTROLLER(click), GTK_PHASE_CAPTURE); /* before a scale */
    g_signal_connect(click, "pressed", G_CALLBACK(on_menu), view);
    gtk_widget_add_controller(GTK_WIDGET(view), GTK_EVENT_CONTROLLER(click));
    GtkEventController *events = gtk_event_controller_legacy_new();
    gtk_event_controller_set_propagation_phase(events, GTK_PHASE_CAPTURE);
    g_signal_connect(events, "event", G_CALLBACK(on_event), view);
    gtk_widget_add_controller(GTK_WIDGET(view), events);
}

TinkerInstrumentView *tinker_instrument_view_new(TinkerDocument *document, TinkerPlayer *player, TinkerHand *hand,
                                                 int number)
{
    TinkerInstrumentView *view = g_object_new(TINKER_TYPE_INSTRUMENT_VIEW, NULL);
    view->document = g_object_ref(document);
    view->player = g_object_ref(player);
    view->hand = hand;
    view->number = number;
    view->generation = G_MAXUINT;
    view->low = INFINITY;
    view->high = -INFINITY;
    view->shown = tinker_scene_instrument_copy(instrument_of(view));
    view->unit = tinker_instrument_unit(tinker_document_scene(document), view->shown);
    view->per_si = per_si_of(view->unit);
    add_parts(view);
    g_signal_connect_object(player, "moved", G_CALLBACK(show), view, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(show), view, G_CONNECT_SWAPPED);
    show(view);
    return view;
}
