/* The parts of an instrument, made anew when the scene has another one in its place. */
#include "gui/instrument/instrument-view.h"

#include <glib/gi18n.h>
#include <math.h>

#include "gui/instrument/instrument-edit.h"
#include "gui/instrument/instrument-view-private.h"
#include "gui/instrument/knob.h"
#include "gui/instrument/meter-face.h"
#include "gui/instrument/value-entry.h"
#include "gui/widget/unparent.h"

#define STEPS       100.0 /* of a range without steps, by key */
#define SCALE_WIDTH 170

G_DEFINE_FINAL_TYPE(TinkerInstrumentView, tinker_instrument_view, GTK_TYPE_WIDGET)

/* Parts ------------------------------------------------------------------------------------------------------------ */

static GtkWidget *turned_part(TinkerInstrumentView *view)
{
    const double from = view->shown->from * view->per_si, to = view->shown->to * view->per_si;
    const double step = view->shown->step > 0 ? view->shown->step * view->per_si : (to - from) / STEPS;
    view->adjustment = g_object_ref_sink(gtk_adjustment_new(from, from, to, step, 10 * step, 0));
    g_signal_connect_object(view->adjustment, "value-changed", G_CALLBACK(instrument_view_on_value_changed), view, 0);
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
        g_signal_connect_object(part, "notify::active", G_CALLBACK(instrument_view_on_switched), view, 0);
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
    view->value = is_number  ? view->part
                  : is_typed ? tinker_value_entry_new(instrument_view_take_typed, view)
                             : gtk_label_new(NULL);
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
    if (is_typed)
        g_signal_connect_swapped(view->value, "notify::css-classes", G_CALLBACK(instrument_view_show_note), view);
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
    instrument_view_show(view);
}

int tinker_instrument_view_number(TinkerInstrumentView *view)
{
    return view->number;
}

GtkWidget *tinker_instrument_view_bar(TinkerInstrumentView *view)
{
    return view->bar;
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
    instrument_view_install_commands(widget_class);
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
    instrument_view_add_menu(view);
    instrument_view_hear_release(view);
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
    view->shown = tinker_scene_instrument_copy(instrument_view_instrument(view));
    view->unit = tinker_instrument_unit(tinker_document_scene(document), view->shown);
    view->per_si = per_si_of(view->unit);
    add_parts(view);
    g_signal_connect_object(player, "moved", G_CALLBACK(instrument_view_show), view, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(instrument_view_show), view, G_CONNECT_SWAPPED);
    instrument_view_show(view);
    return view;
}
