/* Return or leaving an entry sets the row, Escape or Ctrl+Z takes back what was typed. A wrong entry stays, is marked,
 * and says why. With nothing typed, Ctrl+Z undoes the last edit of the scene, as it does elsewhere. */
#include "gui/property/property-field.h"

#include <glib/gi18n.h>

#include "gui/property/law-preview.h"
#include "gui/property/table-chooser.h"
#include "gui/widget/choices.h"
#include "gui/widget/entry-select.h"
#include "gui/widget/popup-menu.h"
#include "gui/widget/unparent.h"

/* px, of 276 that the panel has inside. Controls have a least width so that a long title wraps instead of shifting
 * them. */
#define TITLE_WIDTH   140
#define CONTROL_WIDTH 128

struct _TinkerPropertyField {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPropertyRow *row;
    GtkWidget *title, *control, *detach, *problem;
    GtkWidget *hint;  /* NULL: there was none yet */
    GtkWidget *law;   /* of a typed law, as it is typeset; else NULL */
    gboolean dirty;   /* something was typed, and not taken yet */
    gboolean showing; /* changes of the control are ours */
};

G_DEFINE_FINAL_TYPE(TinkerPropertyField, tinker_property_field, GTK_TYPE_WIDGET)

/* What is wrong ---------------------------------------------------------------------------------------------------- */

static void describe(TinkerPropertyField *field, const char *problem)
{
    const char *description = field->row->description != NULL ? field->row->description : "";
    g_autofree char *own = field->row->hint != NULL
                               ? g_strdup_printf("%s: %s %s", field->row->group, field->row->hint, description)
                               : g_strdup_printf("%s: %s", field->row->group, description);
    gtk_accessible_update_property(GTK_ACCESSIBLE(field->control), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                   problem != NULL ? problem : own, -1);
}

/* NULL: nothing is wrong. */
static void set_problem(TinkerPropertyField *field, const char *problem)
{
    GtkAccessible *accessible = GTK_ACCESSIBLE(field->control);
    gtk_label_set_text(GTK_LABEL(field->problem), problem != NULL ? problem : "");
    gtk_widget_set_visible(field->problem, problem != NULL);
    if (problem != NULL) {
        gtk_widget_add_css_class(field->control, "error");
        gtk_accessible_update_state(accessible, GTK_ACCESSIBLE_STATE_INVALID, GTK_ACCESSIBLE_INVALID_TRUE, -1);
    } else {
        gtk_widget_remove_css_class(field->control, "error");
        gtk_accessible_reset_state(accessible, GTK_ACCESSIBLE_STATE_INVALID);
    }
    describe(field, problem);
}

/* Setting ---------------------------------------------------------------------------------------------------------- */

static gboolean has_focus(TinkerPropertyField *field)
{
    return (gtk_widget_get_state_flags(field->control) & GTK_STATE_FLAG_FOCUS_WITHIN) != 0;
}

/* Where the focus is, the next key replaces it. */
static void show_text(TinkerPropertyField *field)
{
    const char *text = gtk_editable_get_text(GTK_EDITABLE(field->control));
    if (g_str_equal(text, field->row->text)) return;
    field->showing = TRUE;
    gtk_editable_set_text(GTK_EDITABLE(field->control), field->row->text);
    if (has_focus(field)) gtk_editable_select_region(GTK_EDITABLE(field->control), 0, -1);
    field->showing = FALSE;
}

/* What the text of the entry would be as the law, or what is wrong with it, there marked from its place on. */
static void preview_law(TinkerPropertyField *field)
{
    if (field->law == NULL) return;
    const char *text = gtk_editable_get_text(GTK_EDITABLE(field->control));
    g_autoptr(PangoAttrList) marks = pango_attr_list_new();
    g_autoptr(GError) error = NULL;
    int column = 0;
    const gboolean good = tinker_law_preview_show(TINKER_LAW_PREVIEW(field->law), field->row, text, &column, &error);
    if (!good && column > 0 && column <= g_utf8_strlen(text, -1)) {
        PangoAttribute *mark = pango_attr_underline_new(PANGO_UNDERLINE_ERROR);
        mark->start_index = (guint)(g_utf8_offset_to_pointer(text, column - 1) - text);
        pango_attr_list_insert(marks, mark);
    }
    gtk_entry_set_attributes(GTK_ENTRY(field->control), marks);
    set_problem(field, error != NULL ? error->message : NULL);
}

static void revert(TinkerPropertyField *field)
{
    field->dirty = FALSE;
    show_text(field);
    set_problem(field, NULL);
    preview_law(field);
}

static void commit(TinkerPropertyField *field)
{
    g_autoptr(GError) error = NULL;
    if (!field->dirty || field->document == NULL) return;
    g_autofree char *text = g_strdup(gtk_editable_get_text(GTK_EDITABLE(field->control)));
    if (!tinker_property_row_set(field->document, field->row, text, &error)) {
        set_problem(field, error->message);
        return;
    }
    /* The list that is made of the change brings the text as it is shown from now on; without one, it is what it was.
     */
    field->dirty = FALSE;
    set_problem(field, NULL);
    if (g_str_equal(g_strstrip(text), field->row->text)) show_text(field);
}

static void on_activate(TinkerPropertyField *field)
{
    commit(field);
    gtk_editable_select_region(GTK_EDITABLE(field->control), 0, -1);
}

static void on_typed(TinkerPropertyField *field)
{
    const char *text = gtk_editable_get_text(GTK_EDITABLE(field->control));
    if (!field->showing) field->dirty = !g_str_equal(text, field->row->text);
    if (!field->showing) preview_law(field);
}

/* Takes back what is being typed, or else the last edit. Answers whether the key was one of those that undo and redo.
 */
static gboolean undo(TinkerPropertyField *field, guint key, GdkModifierType modifiers)
{
    const GdkModifierType relevant = modifiers & gtk_accelerator_get_default_mod_mask();
    const gboolean shift = relevant == (GDK_CONTROL_MASK | GDK_SHIFT_MASK), plain = relevant == GDK_CONTROL_MASK;
    const guint letter = gdk_keyval_to_lower(key);
    const gboolean back = plain && letter == GDK_KEY_z;
    const gboolean again = (shift && letter == GDK_KEY_z) || (plain && letter == GDK_KEY_y);
    if (back && field->dirty)
        revert(field);
    else if (back)
        tinker_document_undo(field->document);
    else if (again && !field->dirty)
        tinker_document_redo(field->document);
    return back || again;
}

static gboolean on_key(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType modifiers,
                       TinkerPropertyField *field)
{
    if (key != GDK_KEY_Escape || !field->dirty)
        return undo(field, key, modifiers) ? GDK_EVENT_STOP : GDK_EVENT_PROPAGATE;
    revert(field);
    return GDK_EVENT_STOP;
}

static void choose(TinkerPropertyField *field, int choice)
{
    g_autoptr(GError) error = NULL;
    if (field->showing || field->document == NULL || choice == field->row->chosen) return;
    if (choice == field->row->file_choice) {
        tinker_property_field_show(field, field->row); /* until there is a file */
        tinker_choose_table(GTK_WIDGET(field), field->document, field->row);
        return;
    }
    if (tinker_property_row_choose(field->document, field->row, choice, &error)) {
        set_problem(field, NULL);
        return;
    }
    set_problem(field, error->message);
    tinker_property_field_show(field, field->row);
}

static void on_chosen(TinkerPropertyField *field)
{
    guint chosen = gtk_drop_down_get_selected(GTK_DROP_DOWN(field->control));
    if (chosen != GTK_INVALID_LIST_POSITION) choose(field, (int)chosen);
}

static void on_switched(TinkerPropertyField *field)
{
    choose(field, gtk_switch_get_active(GTK_SWITCH(field->control)) ? 1 : 0);
}

static void on_detach(TinkerPropertyField *field)
{
    g_autoptr(GError) error = NULL;
    field->dirty = FALSE;
    if (!tinker_property_row_set(field->document, field->row, "", &error)) set_problem(field, error->message);
}

/* Showing ---------------------------------------------------------------------------------------------------------- */

static void show_choices(TinkerPropertyField *field)
{
    GtkDropDown *control = GTK_DROP_DOWN(field->control);
    GListModel *model = gtk_drop_down_get_model(control);
    guint count = g_strv_length(field->row->choices);
    gboolean same = model != NULL && g_list_model_get_n_items(model) == count;
    for (guint i = 0; same && i < count; i++)
        same = g_str_equal(gtk_string_list_get_string(GTK_STRING_LIST(model), i), field->row->choices[i]);
    if (!same) {
        g_autoptr(GtkStringList) choices = gtk_string_list_new((const char *const *)field->row->choices);
        gtk_drop_down_set_model(control, G_LIST_MODEL(choices));
    }
    gtk_drop_down_set_selected(control,
                               field->row->chosen >= 0 ? (guint)field->row->chosen : GTK_INVALID_LIST_POSITION);
}

static void show_entry(TinkerPropertyField *field)
{
    const char *placeholder = field->row->mixed ? "—" : field->row->kind == TINKER_ROW_END ? _("Not connected") : "";
    if (g_strcmp0(gtk_entry_get_placeholder_text(GTK_ENTRY(field->control)), placeholder) != 0)
        gtk_entry_set_placeholder_text(GTK_ENTRY(field->control), placeholder);
    if (!field->dirty) show_text(field);
    if (field->detach != NULL) gtk_widget_set_sensitive(field->detach, *field->row->text != '\0');
}

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

/* In the entry's own menu. */
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
    field->showing = TRUE;
    gtk_widget_set_sensitive(field->control, row->sensitive);
    switch (row->kind) {
    case TINKER_ROW_CHOICE:
        show_choices(field);
        break;
    case TINKER_ROW_SWITCH:
        gtk_switch_set_active(GTK_SWITCH(field->control), row->chosen == 1);
        break;
    case TINKER_ROW_READING:
        gtk_label_set_text(GTK_LABEL(field->control), row->text);
        break;
    default:
        show_entry(field);
        break;
    }
    field->showing = FALSE;
    if (!same_hint) show_hint(field);
    if (!same || (!same_hint && !gtk_widget_get_visible(field->problem))) set_problem(field, NULL);
    if (!described || !same_control) show_tooltip(field);
    if (row->kind == TINKER_ROW_NUMBER && !same_control) show_entry_menu(field);
    preview_law(field);
}

void tinker_property_field_discard(TinkerPropertyField *field)
{
    if (field->dirty) revert(field);
}

/* Making ----------------------------------------------------------------------------------------------------------- */

static GtkWidget *make_entry(TinkerPropertyField *field)
{
    GtkWidget *entry = gtk_entry_new();
    gtk_editable_set_enable_undo(GTK_EDITABLE(entry), FALSE); /* see undo */
    gtk_editable_set_width_chars(GTK_EDITABLE(entry), 4);
    gtk_editable_set_max_width_chars(GTK_EDITABLE(entry), 12);
    if (field->row->kind == TINKER_ROW_NUMBER) {
        tinker_entry_select_by_click(entry);
        gtk_widget_add_css_class(entry, "numeric");
    }
    tinker_entry_listen(entry, G_CALLBACK(on_typed), G_CALLBACK(on_activate), G_CALLBACK(commit), G_CALLBACK(on_key),
                        field);
    return entry;
}

static GtkWidget *make_drop_down(TinkerPropertyField *field)
{
    GtkWidget *drop_down = gtk_drop_down_new(NULL, NULL);
    tinker_choices_cut_off(GTK_DROP_DOWN(drop_down));
    g_signal_connect_swapped(drop_down, "notify::selected", G_CALLBACK(on_chosen), field);
    return drop_down;
}

static GtkWidget *make_switch(TinkerPropertyField *field)
{
    GtkWidget *control = gtk_switch_new();
    gtk_widget_set_halign(control, GTK_ALIGN_START);
    gtk_widget_set_valign(control, GTK_ALIGN_CENTER);
    g_signal_connect_swapped(control, "notify::active", G_CALLBACK(on_switched), field);
    return control;
}

static GtkWidget *make_label(void)
{
    GtkWidget *label = gtk_label_new(NULL);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_ellipsize(GTK_LABEL(label), PANGO_ELLIPSIZE_END);
    gtk_widget_add_css_class(label, "numeric");
    gtk_widget_add_css_class(label, "reading");
    return label;
}

static GtkWidget *make_control(TinkerPropertyField *field)
{
    switch (field->row->kind) {
    case TINKER_ROW_CHOICE:
        return make_drop_down(field);
    case TINKER_ROW_SWITCH:
        return make_switch(field);
    case TINKER_ROW_READING:
        return make_label();
    default:
        return make_entry(field);
    }
}

static GtkWidget *make_detach(TinkerPropertyField *field)
{
    GtkWidget *button = gtk_button_new_from_icon_name("list-remove-symbolic");
    g_autofree char *label = g_strdup_printf(_("Detach %s"), field->row->title);
    gtk_widget_add_css_class(button, "flat");
    gtk_widget_set_tooltip_text(button, label);
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    g_signal_connect_swapped(button, "clicked", G_CALLBACK(on_detach), field);
    return button;
}

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
    field->control = make_control(field);
    gtk_widget_set_hexpand(field->control, field->row->kind != TINKER_ROW_SWITCH);
    if (field->row->kind != TINKER_ROW_SWITCH && field->row->kind != TINKER_ROW_END)
        gtk_widget_set_size_request(field->control, CONTROL_WIDTH, -1);
    gtk_accessible_update_property(GTK_ACCESSIBLE(field->control), GTK_ACCESSIBLE_PROPERTY_LABEL, field->row->title,
                                   -1);
    gtk_box_append(GTK_BOX(line), field->control);
    if (field->row->kind == TINKER_ROW_END) {
        field->detach = make_detach(field);
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
    set_problem(field, NULL);
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
