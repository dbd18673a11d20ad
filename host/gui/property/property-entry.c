/* Return or leaving an entry sets the row, Escape or Ctrl+Z takes back what was typed. A wrong entry stays, is marked,
 * and says why. With nothing typed, Ctrl+Z undoes the last edit of the scene, as it does elsewhere. */
#include <glib/gi18n.h>

#include "gui/property/law-preview.h"
#include "gui/property/property-field-private.h"
#include "gui/widget/entry-select.h"

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
    if (has_focus(field))
        gtk_editable_select_region(GTK_EDITABLE(field->control), 0, -1);
    else
        gtk_editable_set_position(GTK_EDITABLE(field->control), 0); /* of what is wider the beginning is seen */
    field->showing = FALSE;
}

void property_entry_preview_law(TinkerPropertyField *field)
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
    property_field_set_problem(field, error != NULL ? error->message : NULL);
}

void property_entry_revert(TinkerPropertyField *field)
{
    field->dirty = FALSE;
    show_text(field);
    property_field_set_problem(field, NULL);
    property_entry_preview_law(field);
}

static void commit(TinkerPropertyField *field)
{
    g_autoptr(GError) error = NULL;
    if (!field->dirty || field->document == NULL) return;
    g_autofree char *text = g_strdup(gtk_editable_get_text(GTK_EDITABLE(field->control)));
    if (!tinker_property_row_set(field->document, field->row, text, &error)) {
        property_field_set_problem(field, error->message);
        return;
    }
    /* The list that is made of the change brings the text as it is shown from now on; without one, it is what it was.
     */
    field->dirty = FALSE;
    property_field_set_problem(field, NULL);
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
    if (!field->showing) property_entry_preview_law(field);
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
        property_entry_revert(field);
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
    property_entry_revert(field);
    return GDK_EVENT_STOP;
}

void property_entry_show(TinkerPropertyField *field)
{
    const char *placeholder = field->row->mixed ? "—" : field->row->kind == TINKER_ROW_END ? _("Not connected") : "";
    if (g_strcmp0(gtk_entry_get_placeholder_text(GTK_ENTRY(field->control)), placeholder) != 0)
        gtk_entry_set_placeholder_text(GTK_ENTRY(field->control), placeholder);
    if (!field->dirty) show_text(field);
    if (field->detach != NULL) gtk_widget_set_sensitive(field->detach, *field->row->text != '\0');
}

GtkWidget *property_entry_new(TinkerPropertyField *field)
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
