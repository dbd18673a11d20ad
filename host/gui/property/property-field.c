/* A property: title, control, what is wrong with what was entered, a hint, a law as it is typeset. */
#include "gui/property/property-field.h"

#include <glib/gi18n.h>

#include "gui/property/law-preview.h"
#include "gui/property/property-field-private.h"
#include "gui/widget/popup-menu.h"
#include "gui/widget/unparent.h"

/* px, of 276 that the panel has inside. Controls have a least width so that a long title wraps instead of shifting
 * them. */
#define TITLE_WIDTH   140
#define CONTROL_WIDTH 128

G_DEFINE_FINAL_TYPE(TinkerPropertyField, tinker_property_field, GTK_TYPE_WIDGET)

/* Showing ---------------------------------------------------------------------------------------------------------- */

static GtkWidget *make_line(const char *style)
{
    GtkWidget *line = g_object_new(GTK_TYPE_LABEL, "accessible-role", GTK_ACCESSIBLE_ROLE_ALERT, NULL);
    gtk_label_set_xalign(GTK_LABEL(line), 0);
    gtk_label_set_wrap(GTK_LABEL(line), TRUE);
    gtk_label_set_wrap_mode(GTK_LABEL(line), PANGO_WRAP_WORD_CHAR);
    gtk_label_set_max_width_chars(GTK_LABEL(line), 1);
    gtk_widget_add_css_class(line, style);
    gtk_widget_add_css_class(line, "caption");
    return line;
}

/* There only while there is one: what is merely hidden, assistive programs would still find. */
static void show_hint(TinkerPropertyField *field)
{
    const char *hint = field->row->hint;
    if (hint == NULL) {
        g_clear_pointer(&field->hint, gtk_widget_unparent);
        return;
    }
    if (field->hint == NULL) {
        field->hint = make_line("warning");
        gtk_widget_set_parent(field->hint, GTK_WIDGET(field));
    }
    gtk_label_set_text(GTK_LABEL(field->hint), hint);
}

/* Controls are made of numbers, here as well as in the menu of the block: by the right button on the number or its
 * title. (transfer full) */
static GMenuModel *control_menu(const TinkerPropertyField *field)
{
    g_autoptr(GMenuItem) item = g_menu_item_new(_("Add C_ontrol"), NULL);
    GMenu *menu = g_menu_new();
    g_menu_item_set_action_and_target_value(item, "win.add-control", g_variant_new_string(field->row->control));
    g_menu_append_item(menu, item);
    return G_MENU_MODEL(menu);
}

static void on_title_menu(GtkGestureClick *gesture, int presses, double x, double y, TinkerPropertyField *field)
{
    if (field->row->control == NULL) return;
    g_autoptr(GMenuModel) menu = control_menu(field);
    gtk_gesture_set_state(GTK_GESTURE(gesture), GTK_EVENT_SEQUENCE_CLAIMED);
    tinker_popup_menu(field->title, menu, x, y);
}

static void add_title_menu(TinkerPropertyField *field)
{
    GtkGesture *click = gtk_gesture_click_new();
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(click), GDK_BUTTON_SECONDARY);
    g_signal_connect(click, "pressed", G_CALLBACK(on_title_menu), field);
    gtk_widget_add_controller(field->title, GTK_EVENT_CONTROLLER(click));
}

/* Of the title, not of the control, where it would cover the next one: what it is, and that there is a slider for it.
 */
static void show_tooltip(TinkerPropertyField *field)
{
    const char *description = field->row->description;
    g_autofree char *text =
        field->row->control == NULL
            ? g_strdup(description)
            : g_strdup_printf("%s%s%s", description != NULL ? description : "", description != NULL ? "\n" : "",
                              _("A slider for it: right-click, Add Control"));
    gtk_widget_set_tooltip_text(field->title, text);
}

/* In the entry's own menu. */
static void show_entry_menu(TinkerPropertyField *field)
{
    g_autoptr(GMenuModel) menu = field->row->control != NULL ? control_menu(field) : NULL;
    gtk_entry_set_extra_menu(GTK_ENTRY(field->control), menu);
}

void tinker_property_field_show(TinkerPropertyField *field, TinkerPropertyRow *row)
{
    gboolean same_hint = g_strcmp0(field->row->hint, row->hint) == 0;
    gboolean same = tinker_property_row_same_target(field->row, row);
    gboolean described = g_strcmp0(field->row->description, row->description) == 0;
    const gboolean same_control = g_strcmp0(field->row->control, row->control) == 0;
    tinker_property_row_ref(row);
    tinker_property_row_unref(field->row);
    field->row = row;
    if (!same) field->dirty = FALSE;
    property_control_show(field);
    if (!same_hint) show_hint(field);
    if (!same || (!same_hint && !gtk_widget_get_visible(field->problem))) property_field_set_problem(field, NULL);
    if (!described || !same_control) show_tooltip(field);
    if (row->kind == TINKER_ROW_NUMBER && !same_control) show_entry_menu(field);
    property_entry_preview_law(field);
}

void tinker_property_field_discard(TinkerPropertyField *field)
{
    if (field->dirty) property_entry_revert(field);
}

/* Making ----------------------------------------------------------------------------------------------------------- */

static void make_parts(TinkerPropertyField *field)
{
    GtkWidget *line = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6);
    field->title = gtk_label_new(field->row->title);
    gtk_label_set_xalign(GTK_LABEL(field->title), 0);
    gtk_label_set_wrap(GTK_LABEL(field->title), TRUE);
    gtk_label_set_wrap_mode(GTK_LABEL(field->title), PANGO_WRAP_WORD_CHAR);
    gtk_label_set_max_width_chars(GTK_LABEL(field->title), 1);
    gtk_widget_set_size_request(field->title, TITLE_WIDTH, -1);
    gtk_box_append(GTK_BOX(line), field->title);
    field->control = property_control_new(field);
    gtk_widget_set_hexpand(field->control, field->row->kind != TINKER_ROW_SWITCH);
    if (field->row->kind != TINKER_ROW_SWITCH && field->row->kind != TINKER_ROW_END)
        gtk_widget_set_size_request(field->control, CONTROL_WIDTH, -1);
    gtk_accessible_update_property(GTK_ACCESSIBLE(field->control), GTK_ACCESSIBLE_PROPERTY_LABEL, field->row->title,
                                   -1);
    gtk_box_append(GTK_BOX(line), field->control);
    if (field->row->kind == TINKER_ROW_END) {
        field->detach = property_control_detach_new(field);
        gtk_box_append(GTK_BOX(line), field->detach);
    }
    gtk_widget_set_parent(line, GTK_WIDGET(field));

    field->problem = make_line("error");
    gtk_widget_set_parent(field->problem, GTK_WIDGET(field));
    if (!field->row->is_law) return;
    field->law = tinker_law_preview_new(field->document);
    gtk_widget_set_parent(field->law, GTK_WIDGET(field));
}

GtkWidget *tinker_property_field_new(TinkerDocument *document, TinkerPropertyRow *row)
{
    TinkerPropertyField *field = g_object_new(TINKER_TYPE_PROPERTY_FIELD, NULL);
    field->document = g_object_ref(document);
    field->row = tinker_property_row_ref(row);
    make_parts(field);
    show_tooltip(field);
    property_field_set_problem(field, NULL);
    show_hint(field);
    add_title_menu(field);
    if (row->kind == TINKER_ROW_NUMBER) show_entry_menu(field);
    tinker_property_field_show(field, row);
    return GTK_WIDGET(field);
}

static gboolean tinker_property_field_grab_focus(GtkWidget *widget)
{
    return gtk_widget_grab_focus(TINKER_PROPERTY_FIELD(widget)->control);
}

static void tinker_property_field_dispose(GObject *object)
{
    TinkerPropertyField *field = TINKER_PROPERTY_FIELD(object);
    g_clear_object(&field->document);
    field->hint = field->law = NULL;
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_pointer(&field->row, tinker_property_row_unref);
    G_OBJECT_CLASS(tinker_property_field_parent_class)->dispose(object);
}

static void tinker_property_field_class_init(TinkerPropertyFieldClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_property_field_dispose;
    GTK_WIDGET_CLASS(class)->grab_focus = tinker_property_field_grab_focus;
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BOX_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "propertyfield");
}

static void tinker_property_field_init(TinkerPropertyField *field)
{
    GtkLayoutManager *layout = gtk_widget_get_layout_manager(GTK_WIDGET(field));
    gtk_orientable_set_orientation(GTK_ORIENTABLE(layout), GTK_ORIENTATION_VERTICAL);
}
