/* A flow of buttons under a heading for each topic. What does not hold all words that are searched for is hidden, with
 * the headings that have nothing left. */
#include "gui/gallery/gallery.h"

#include <adwaita.h>
#include <glib/gi18n.h>

#include "gui/gallery/example-button.h"
#include "gui/text/translate.h"
#include "gui/text/word-search.h"

#define WIDTH  820
#define HEIGHT 640
#define LEAST  4 /* in a row */
#define MOST   8
#define WORDS  "tinker-words" /* data of a child of a flow: the words that are searched */

struct _TinkerGallery {
    AdwWindow parent_instance;
    TinkerExamplePictures *pictures;
    GtkWidget *search, *nothing;
    GPtrArray *headings, *flows; /* of GtkWidget, borrowed; one of each a topic */
    GStrv wanted;                /* stems of words; NULL: all */
};

#define TINKER_TYPE_GALLERY (tinker_gallery_get_type())
G_DECLARE_FINAL_TYPE(TinkerGallery, tinker_gallery, TINKER, GALLERY, AdwWindow)
G_DEFINE_FINAL_TYPE(TinkerGallery, tinker_gallery, ADW_TYPE_WINDOW)

/* Searching -------------------------------------------------------------------------------------------------------- */

static gboolean has_all_words(GtkFlowBoxChild *child, gpointer data)
{
    const TinkerGallery *gallery = data;
    return gallery->wanted == NULL || tinker_search_finds(g_object_get_data(G_OBJECT(child), WORDS), gallery->wanted);
}

static void on_search(GtkSearchEntry *entry, TinkerGallery *gallery)
{
    gboolean any = FALSE;
    g_strfreev(gallery->wanted);
    gallery->wanted = tinker_search_stems(gtk_editable_get_text(GTK_EDITABLE(entry)));
    for (guint i = 0; i < gallery->flows->len; i++) {
        GtkWidget *flow = g_ptr_array_index(gallery->flows, i);
        gboolean some = FALSE;
        gtk_flow_box_invalidate_filter(GTK_FLOW_BOX(flow));
        for (GtkWidget *child = gtk_widget_get_first_child(flow); child != NULL && !some;
             child = gtk_widget_get_next_sibling(child))
            some = has_all_words(GTK_FLOW_BOX_CHILD(child), gallery);
        gtk_widget_set_visible(flow, some);
        gtk_widget_set_visible(g_ptr_array_index(gallery->headings, i), some);
        any |= some;
    }
    gtk_widget_set_visible(gallery->nothing, !any);
}

/* Parts ------------------------------------------------------------------------------------------------------------ */

/* What is opened is the window's, to which its action belongs. */
static void on_chosen(GtkWidget *button, const TinkerExample *example)
{
    GtkWindow *gallery = GTK_WINDOW(gtk_widget_get_ancestor(button, TINKER_TYPE_GALLERY));
    GtkWindow *window = gtk_window_get_transient_for(gallery);
    g_autofree char *path = g_strdup(example->path);
    gtk_window_close(gallery);
    if (window != NULL) gtk_widget_activate_action(GTK_WIDGET(window), "win.open-example", "s", path);
}

/* Title, and the first sentence of what it is about. */
static GtkWidget *entry_new(TinkerGallery *gallery, const TinkerTopic *topic, const TinkerExample *example)
{
    GtkWidget *child = gtk_flow_box_child_new(), *button = tinker_example_button_new(example, gallery->pictures);
    const char *description = tinker_translate(example->description);
    const char *title = tinker_translate_title(example->title, example->description);
    g_autofree char *words =
        g_strjoin("\n", topic->title, title, example->title, description, example->description, NULL);
    g_signal_connect(button, "clicked", G_CALLBACK(on_chosen), (gpointer)example);
    gtk_flow_box_child_set_child(GTK_FLOW_BOX_CHILD(child), button);
    gtk_widget_set_focusable(child, FALSE); /* the button has it */
    g_object_set_data_full(G_OBJECT(child), WORDS, tinker_search_words(words), (GDestroyNotify)g_strfreev);
    return child;
}

static void add_topic(TinkerGallery *gallery, GtkWidget *box, const TinkerTopic *topic)
{
    GtkWidget *heading = gtk_label_new(topic->title), *flow = gtk_flow_box_new();
    gtk_label_set_xalign(GTK_LABEL(heading), 0);
    gtk_widget_add_css_class(heading, "heading");
    gtk_flow_box_set_selection_mode(GTK_FLOW_BOX(flow), GTK_SELECTION_NONE);
    gtk_flow_box_set_homogeneous(GTK_FLOW_BOX(flow), TRUE);
    gtk_flow_box_set_min_children_per_line(GTK_FLOW_BOX(flow), LEAST);
    gtk_flow_box_set_max_children_per_line(GTK_FLOW_BOX(flow), MOST);
    gtk_flow_box_set_filter_func(GTK_FLOW_BOX(flow), has_all_words, gallery, NULL);
    gtk_accessible_update_property(GTK_ACCESSIBLE(flow), GTK_ACCESSIBLE_PROPERTY_LABEL, topic->title, -1);
    for (guint i = 0; i < topic->examples->len; i++)
        gtk_flow_box_append(GTK_FLOW_BOX(flow), entry_new(gallery, topic, g_ptr_array_index(topic->examples, i)));
    gtk_box_append(GTK_BOX(box), heading);
    gtk_box_append(GTK_BOX(box), flow);
    g_ptr_array_add(gallery->headings, heading);
    g_ptr_array_add(gallery->flows, flow);
}

static GtkWidget *content_new(TinkerGallery *gallery, GtkWidget *box)
{
    GtkWidget *all = gtk_box_new(GTK_ORIENTATION_VERTICAL, 0), *bar = adw_header_bar_new();
    GtkWidget *scrolled = gtk_scrolled_window_new();
    gallery->search = gtk_search_entry_new();
    g_object_set(gallery->search, "placeholder-text", _("Search titles and descriptions"), "hexpand", TRUE, NULL);
    gtk_accessible_update_property(GTK_ACCESSIBLE(gallery->search), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   _("Search titles and descriptions"), -1);
    g_signal_connect(gallery->search, "search-changed", G_CALLBACK(on_search), gallery);
    g_signal_connect_swapped(gallery->search, "stop-search", G_CALLBACK(gtk_window_close), gallery);
    adw_header_bar_set_title_widget(ADW_HEADER_BAR(bar), gallery->search);
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scrolled), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), box);
    gtk_widget_set_vexpand(scrolled, TRUE);
    gallery->nothing = gtk_label_new(_("No example has all of these words"));
    gtk_widget_set_visible(gallery->nothing, FALSE);
    gtk_widget_add_css_class(gallery->nothing, "dim-label");
    gtk_box_append(GTK_BOX(box), gallery->nothing);
    gtk_box_append(GTK_BOX(all), bar);
    gtk_box_append(GTK_BOX(all), scrolled);
    return all;
}

/* The window ------------------------------------------------------------------------------------------------------- */

static void tinker_gallery_finalize(GObject *object)
{
    TinkerGallery *gallery = TINKER_GALLERY(object);
    tinker_example_pictures_free(gallery->pictures);
    g_ptr_array_unref(gallery->headings);
    g_ptr_array_unref(gallery->flows);
    g_strfreev(gallery->wanted);
    G_OBJECT_CLASS(tinker_gallery_parent_class)->finalize(object);
}

static void tinker_gallery_class_init(TinkerGalleryClass *class)
{
    G_OBJECT_CLASS(class)->finalize = tinker_gallery_finalize;
    gtk_widget_class_add_binding_action(GTK_WIDGET_CLASS(class), GDK_KEY_Escape, 0, "window.close", NULL);
}

static void tinker_gallery_init(TinkerGallery *gallery)
{
    gallery->headings = g_ptr_array_new();
    gallery->flows = g_ptr_array_new();
    gtk_window_set_title(GTK_WINDOW(gallery), _("Examples"));
    gtk_window_set_default_size(GTK_WINDOW(gallery), WIDTH, HEIGHT);
    gtk_window_set_modal(GTK_WINDOW(gallery), TRUE);
}

void tinker_gallery_show(GtkWindow *window, TinkerCatalogue *catalogue)
{
    TinkerGallery *gallery = g_object_new(TINKER_TYPE_GALLERY, "transient-for", window, NULL);
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 6);
    const GPtrArray *topics = tinker_examples(catalogue);
    gallery->pictures = tinker_example_pictures_new(catalogue);
    gtk_widget_add_css_class(box, "gallery");
    for (guint t = 0; t < topics->len; t++)
        add_topic(gallery, box, g_ptr_array_index(topics, t));
    adw_window_set_content(ADW_WINDOW(gallery), content_new(gallery, box));
    gtk_window_present(GTK_WINDOW(gallery));
    gtk_widget_grab_focus(gallery->search);
}
