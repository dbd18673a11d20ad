/* What is typed stays until it is taken or given up: values that come meanwhile are shown afterwards. */
#include "gui/instrument/value-entry.h"

#include "gui/widget/entry-select.h"

#define WIDTH 10 /* characters */
#define DATA  "tinker-value-entry"

typedef struct {
    TinkerValueTaken take;
    gpointer data;
    char *shown;
    gboolean showing; /* the change is ours */
    gboolean typed;   /* not taken yet */
} ValueEntry;

static void value_entry_free(gpointer data)
{
    g_free(((ValueEntry *)data)->shown);
    g_free(data);
}

static ValueEntry *of_widget(GtkWidget *entry)
{
    return g_object_get_data(G_OBJECT(entry), DATA);
}

static void put_text(GtkWidget *entry)
{
    ValueEntry *self = of_widget(entry);
    gtk_widget_remove_css_class(entry, "error");
    self->typed = FALSE;
    if (g_str_equal(gtk_editable_get_text(GTK_EDITABLE(entry)), self->shown)) return;
    self->showing = TRUE;
    gtk_editable_set_text(GTK_EDITABLE(entry), self->shown);
    self->showing = FALSE;
}

void tinker_value_entry_show(GtkWidget *entry, const char *text)
{
    ValueEntry *self = of_widget(entry);
    if (g_strcmp0(self->shown, text) == 0) return;
    g_free(self->shown);
    self->shown = g_strdup(text);
    if (!self->typed) put_text(entry);
}

static void on_changed(GtkWidget *entry)
{
    ValueEntry *self = of_widget(entry);
    if (!self->showing) self->typed = TRUE;
}

static void on_activate(GtkWidget *entry)
{
    ValueEntry *self = of_widget(entry);
    if (!self->typed) return;
    g_autofree char *text = g_strdup(gtk_editable_get_text(GTK_EDITABLE(entry)));
    self->typed = FALSE; /* what is shown from now on is what was taken */
    if (self->take(text, self->data)) {
        put_text(entry);
        return;
    }
    self->typed = TRUE;
    gtk_widget_add_css_class(entry, "error");
}

static gboolean on_key(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType modifiers,
                       GtkWidget *entry)
{
    if (key != GDK_KEY_Escape || !of_widget(entry)->typed) return GDK_EVENT_PROPAGATE;
    put_text(entry);
    return GDK_EVENT_STOP;
}

GtkWidget *tinker_value_entry_new(TinkerValueTaken take, gpointer data)
{
    ValueEntry *self = g_new0(ValueEntry, 1);
    GtkWidget *entry = gtk_entry_new();
    *self = (ValueEntry){.take = take, .data = data, .shown = g_strdup("")};
    g_object_set_data_full(G_OBJECT(entry), DATA, self, value_entry_free);
    gtk_editable_set_width_chars(GTK_EDITABLE(entry), WIDTH);
    gtk_editable_set_max_width_chars(GTK_EDITABLE(entry), WIDTH);
    gtk_editable_set_alignment(GTK_EDITABLE(entry), 0.5F);
    gtk_widget_set_halign(entry, GTK_ALIGN_CENTER);
    tinker_entry_select_by_click(entry);
    tinker_entry_listen(entry, G_CALLBACK(on_changed), G_CALLBACK(on_activate), G_CALLBACK(put_text),
                        G_CALLBACK(on_key), entry);
    return entry;
}
