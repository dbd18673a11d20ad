/* Return takes all three; what is wrong is said below them. */
#include "gui/instrument/instrument-range.h"

#include <glib/gi18n.h>

#include "gui/instrument/instrument-edit.h"
#include "gui/text/number-text.h"
#include "gui/text/sentence.h"

#define DIGITS 7

typedef struct {
    GtkWidget *popover, *entries[3], *problem;
    TinkerDocument *document;
    int number;
} Range;

static const TinkerSceneInstrument *control_of(Range *range)
{
    GPtrArray *all = tinker_scene_instruments(tinker_document_scene(range->document));
    return range->number < (int)all->len ? g_ptr_array_index(all, (guint)range->number) : NULL;
}

static gboolean take(Range *range, GError **error)
{
    TinkerScene *scene = tinker_document_scene(range->document);
    const TinkerSceneInstrument *control = control_of(range);
    TinkerNumber number;
    double values[3];
    if (control == NULL ||
        !tinker_scene_find_number(scene, tinker_scene_find_block(scene, control->block), control->of, &number))
        return TRUE; /* it is no longer there */
    const char *unit = tinker_instrument_unit(scene, control);
    for (int i = 0; i < 3; i++)
        if (!tinker_number_read(gtk_editable_get_text(GTK_EDITABLE(range->entries[i])), number.type->dimension, unit,
                                &values[i], error))
            return FALSE;
    return tinker_instrument_set_range(range->document, range->number, values[0], values[1], values[2], error);
}

static void on_activate(GtkWidget *entry, Range *range)
{
    g_autoptr(GError) error = NULL;
    if (take(range, &error)) {
        gtk_popover_popdown(GTK_POPOVER(range->popover));
        return;
    }
    TinkerScene *scene = tinker_document_scene(range->document);
    const TinkerSceneInstrument *control = control_of(range);
    const TinkerBlockId block = control != NULL ? tinker_scene_find_block(scene, control->block) : TINKER_NO_BLOCK;
    g_autofree char *titled =
        tinker_with_titles(error->message, block != TINKER_NO_BLOCK ? tinker_scene_block_class(scene, block) : NULL);
    g_autofree char *sentence = tinker_sentence(titled);
    gtk_label_set_text(GTK_LABEL(range->problem), sentence);
    gtk_widget_set_visible(range->problem, TRUE);
}

static gboolean unparent_later(gpointer popover)
{
    if (gtk_widget_get_parent(popover) != NULL) gtk_widget_unparent(popover);
    return G_SOURCE_REMOVE;
}

static void on_closed(GtkWidget *popover)
{
    g_idle_add_full(G_PRIORITY_DEFAULT_IDLE, unparent_later, g_object_ref(popover), g_object_unref);
}

static void add_entries(Range *range, GtkWidget *grid)
{
    const TinkerSceneInstrument *control = control_of(range);
    const char *titles[] = {_("From"), _("To"), _("Step")};
    const double values[] = {control->from, control->to, control->step};
    const char *unit = tinker_instrument_unit(tinker_document_scene(range->document), control);
    for (int i = 0; i < 3; i++) {
        g_autofree char *text = tinker_number_short(values[i], unit, DIGITS);
        GtkWidget *label = gtk_label_new(titles[i]);
        range->entries[i] = gtk_entry_new();
        gtk_editable_set_text(GTK_EDITABLE(range->entries[i]), text);
        gtk_label_set_xalign(GTK_LABEL(label), 0);
        gtk_accessible_update_property(GTK_ACCESSIBLE(range->entries[i]), GTK_ACCESSIBLE_PROPERTY_LABEL, titles[i], -1);
        g_signal_connect(range->entries[i], "activate", G_CALLBACK(on_activate), range);
        gtk_grid_attach(GTK_GRID(grid), label, 0, i, 1, 1);
        gtk_grid_attach(GTK_GRID(grid), range->entries[i], 1, i, 1, 1);
    }
}

void tinker_instrument_range_popup(GtkWidget *over, TinkerDocument *document, int number)
{
    Range *range = g_new0(Range, 1);
    GtkWidget *grid = gtk_grid_new(), *ok = gtk_button_new_with_label(_("Set Range"));
    range->document = document;
    range->number = number;
    range->popover = gtk_popover_new();
    gtk_grid_set_row_spacing(GTK_GRID(grid), 6);
    gtk_grid_set_column_spacing(GTK_GRID(grid), 9);
    add_entries(range, grid);
    range->problem = g_object_new(GTK_TYPE_LABEL, "accessible-role", GTK_ACCESSIBLE_ROLE_ALERT, "wrap", TRUE,
                                  "max-width-chars", 30, "xalign", 0.0, "visible", FALSE, NULL);
    gtk_widget_add_css_class(range->problem, "error");
    gtk_grid_attach(GTK_GRID(grid), range->problem, 0, 3, 2, 1);
    gtk_widget_add_css_class(ok, "suggested-action");
    g_signal_connect(ok, "clicked", G_CALLBACK(on_activate), range);
    gtk_grid_attach(GTK_GRID(grid), ok, 0, 4, 2, 1);
    gtk_popover_set_child(GTK_POPOVER(range->popover), grid);
    g_object_set_data_full(G_OBJECT(range->popover), "range", range, g_free);
    gtk_widget_set_parent(range->popover, over);
    g_signal_connect(range->popover, "closed", G_CALLBACK(on_closed), NULL);
    gtk_popover_popup(GTK_POPOVER(range->popover));
}
