/* The examples are the first of each topic; all are in the gallery. */
#include "gui/gallery/welcome.h"

#include <adwaita.h>
#include <glib/gi18n.h>

#include "gui/canvas/canvas.h"
#include "gui/gallery/example-button.h"
#include "gui/widget/unparent.h"

#define SHOWN_EXAMPLES 4
#define CARD_WIDTH     660
#define ROOMY_HEIGHT   460 /* widget units, of the canvas: with less its pictures are smaller */

struct _TinkerWelcome {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    GtkWidget *examples;
    TinkerExamplePictures *pictures; /* NULL until it is shown */
    guint preparation;               /* id of the idle source, or 0 */
    gboolean is_small;               /* the canvas, as it was when it had its size last */
    guint fitting;                   /* id of the idle source, or 0 */
};

G_DEFINE_FINAL_TYPE(TinkerWelcome, tinker_welcome, GTK_TYPE_WIDGET)

/* The card --------------------------------------------------------------------------------------------------------- */

static void fit_pictures(TinkerWelcome *welcome)
{
    for (GtkWidget *child = gtk_widget_get_first_child(welcome->examples); child != NULL;
         child = gtk_widget_get_next_sibling(child))
        tinker_example_button_set_small(gtk_flow_box_child_get_child(GTK_FLOW_BOX_CHILD(child)), welcome->is_small);
}

/* The first of each topic, for they are unlike one another. Not before the card is shown: the files of all examples are
 * read for it. */
static void add_examples(TinkerWelcome *welcome)
{
    const GPtrArray *topics = tinker_examples(tinker_document_catalogue(welcome->document));
    if (welcome->pictures != NULL) return;
    welcome->pictures = tinker_example_pictures_new(tinker_document_catalogue(welcome->document));
    for (guint t = 0; t < MIN(topics->len, SHOWN_EXAMPLES); t++) {
        const TinkerTopic *topic = g_ptr_array_index(topics, t);
        const TinkerExample *example = g_ptr_array_index(topic->examples, 0);
        GtkWidget *button = tinker_example_button_new(example, welcome->pictures);
        gtk_actionable_set_action_name(GTK_ACTIONABLE(button), "win.open-example");
        gtk_actionable_set_action_target(GTK_ACTIONABLE(button), "s", example->path);
        gtk_flow_box_append(GTK_FLOW_BOX(welcome->examples), button);
        gtk_widget_set_focusable(gtk_widget_get_parent(button), FALSE); /* the button itself has the focus */
    }
    fit_pictures(welcome);
}

static GtkWidget *label_new(const char *text, const char *css_class)
{
    GtkWidget *label = gtk_label_new(text);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_widget_add_css_class(label, css_class);
    return label;
}

static GtkWidget *step_row(int number, const char *text)
{
    GtkWidget *row = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 12);
    g_autofree char *digit = g_strdup_printf("%d", number);
    GtkWidget *badge = gtk_label_new(digit);
    gtk_widget_add_css_class(badge, "welcome-number");
    gtk_widget_set_valign(badge, GTK_ALIGN_START);
    GtkWidget *label = label_new(text, "welcome-step");
    gtk_widget_set_hexpand(label, TRUE);
    gtk_label_set_max_width_chars(GTK_LABEL(label), 60);
    gtk_box_append(GTK_BOX(row), badge);
    gtk_box_append(GTK_BOX(row), label);
    return row;
}

static GtkWidget *examples_row(void)
{
    GtkWidget *row = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 12), *all = gtk_button_new_with_label(_("All Examples…"));
    GtkWidget *heading = label_new(_("Or Open an Example"), "heading");
    gtk_widget_set_hexpand(heading, TRUE);
    gtk_actionable_set_action_name(GTK_ACTIONABLE(all), "win.gallery");
    gtk_widget_add_css_class(all, "flat");
    gtk_box_append(GTK_BOX(row), heading);
    gtk_box_append(GTK_BOX(row), all);
    return row;
}

static GtkWidget *card_new(TinkerWelcome *welcome)
{
    static const char *const steps[] = {
        N_("Click a block on the left to place it, or drag it onto the canvas."),
        N_("Drag the ends of springs, dampers and the like onto blocks to connect them."),
        N_("Press Play, and change any property on the right to see what it does."),
    };
    GtkWidget *card = gtk_box_new(GTK_ORIENTATION_VERTICAL, 10);
    gtk_widget_add_css_class(card, "card");
    gtk_widget_add_css_class(card, "welcome");
    gtk_box_append(GTK_BOX(card), label_new(_("Build Something That Moves"), "title-2"));
    for (int i = 0; i < (int)G_N_ELEMENTS(steps); i++)
        gtk_box_append(GTK_BOX(card), step_row(i + 1, _(steps[i])));
    gtk_box_append(GTK_BOX(card), examples_row());
    welcome->examples = gtk_flow_box_new();
    gtk_flow_box_set_selection_mode(GTK_FLOW_BOX(welcome->examples), GTK_SELECTION_NONE);
    gtk_flow_box_set_homogeneous(GTK_FLOW_BOX(welcome->examples), TRUE);
    gtk_flow_box_set_column_spacing(GTK_FLOW_BOX(welcome->examples), 6);
    gtk_flow_box_set_min_children_per_line(GTK_FLOW_BOX(welcome->examples), SHOWN_EXAMPLES);
    gtk_flow_box_set_max_children_per_line(GTK_FLOW_BOX(welcome->examples), SHOWN_EXAMPLES);
    gtk_box_append(GTK_BOX(card), welcome->examples);
    return card;
}

/* When it is shown ------------------------------------------------------------------------------------------------- */

static void update(TinkerWelcome *welcome)
{
    gboolean idle = tinker_player_state(welcome->player) == TINKER_PLAYER_SETUP;
    gtk_widget_set_visible(GTK_WIDGET(welcome), idle && tinker_document_is_empty(welcome->document));
}

static gboolean prepare(gpointer data)
{
    TinkerWelcome *welcome = data;
    welcome->preparation = 0;
    add_examples(welcome);
    return G_SOURCE_REMOVE;
}

static gboolean on_fit(gpointer data)
{
    TinkerWelcome *welcome = data;
    welcome->fitting = 0;
    gtk_widget_set_valign(GTK_WIDGET(welcome), welcome->is_small ? GTK_ALIGN_START : GTK_ALIGN_CENTER);
    fit_pictures(welcome);
    return G_SOURCE_REMOVE;
}

/* Called whenever it gets its place, before it has it. What is larger or smaller then is asked for afterwards. */
static gboolean on_placed(GtkOverlay *overlay, GtkWidget *child, GdkRectangle *place, TinkerWelcome *welcome)
{
    if (child != GTK_WIDGET(welcome)) return FALSE;
    const int width = gtk_widget_get_width(GTK_WIDGET(overlay)), height = gtk_widget_get_height(GTK_WIDGET(overlay));
    const gboolean is_small = width < CARD_WIDTH || height < ROOMY_HEIGHT;
    if (is_small != welcome->is_small && welcome->fitting == 0) welcome->fitting = g_idle_add(on_fit, welcome);
    welcome->is_small = is_small;
    gtk_widget_queue_draw(gtk_overlay_get_child(overlay));
    return FALSE; /* where it is anyway */
}

/* Names and labels make way for it. */
static void add_panel(TinkerWelcome *welcome, GArray *boxes, GtkWidget *canvas)
{
    graphene_rect_t place;
    if (!gtk_widget_get_mapped(GTK_WIDGET(welcome)) || !gtk_widget_compute_bounds(GTK_WIDGET(welcome), canvas, &place))
        return;
    const double box[4] = {place.origin.x, place.origin.y, place.origin.x + place.size.width,
                           place.origin.y + place.size.height};
    g_array_append_vals(boxes, box, 1);
}

static void tinker_welcome_map(GtkWidget *widget)
{
    TinkerWelcome *welcome = TINKER_WELCOME(widget);
    GTK_WIDGET_CLASS(tinker_welcome_parent_class)->map(widget);
    if (welcome->preparation == 0 && welcome->pictures == NULL)
        welcome->preparation = g_idle_add_full(G_PRIORITY_LOW, prepare, welcome, NULL);
}

static void tinker_welcome_dispose(GObject *object)
{
    TinkerWelcome *welcome = TINKER_WELCOME(object);
    g_clear_handle_id(&welcome->preparation, g_source_remove);
    g_clear_handle_id(&welcome->fitting, g_source_remove);
    g_clear_pointer(&welcome->pictures, tinker_example_pictures_free);
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_object(&welcome->player);
    g_clear_object(&welcome->document);
    G_OBJECT_CLASS(tinker_welcome_parent_class)->dispose(object);
}

static void tinker_welcome_class_init(TinkerWelcomeClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_welcome_dispose;
    GTK_WIDGET_CLASS(class)->map = tinker_welcome_map;
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BIN_LAYOUT);
    gtk_widget_class_set_accessible_role(GTK_WIDGET_CLASS(class), GTK_ACCESSIBLE_ROLE_GROUP);
}

static void tinker_welcome_init(TinkerWelcome *welcome)
{
    GtkWidget *clamp = adw_clamp_new(), *scrolled = gtk_scrolled_window_new(); /* which it needs in a small window */
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scrolled), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_propagate_natural_width(GTK_SCROLLED_WINDOW(scrolled), TRUE);
    gtk_scrolled_window_set_propagate_natural_height(GTK_SCROLLED_WINDOW(scrolled), TRUE);
    adw_clamp_set_maximum_size(ADW_CLAMP(clamp), CARD_WIDTH);
    adw_clamp_set_tightening_threshold(ADW_CLAMP(clamp), CARD_WIDTH);
    adw_clamp_set_child(ADW_CLAMP(clamp), card_new(welcome));
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), clamp);
    gtk_widget_set_parent(scrolled, GTK_WIDGET(welcome));
    gtk_widget_set_halign(GTK_WIDGET(welcome), GTK_ALIGN_CENTER);
    gtk_widget_set_valign(GTK_WIDGET(welcome), GTK_ALIGN_CENTER);
    gtk_accessible_update_property(GTK_ACCESSIBLE(welcome), GTK_ACCESSIBLE_PROPERTY_LABEL, _("First Steps"), -1);
}

void tinker_welcome_add(GtkOverlay *overlay, TinkerDocument *document, TinkerPlayer *player)
{
    TinkerWelcome *welcome = g_object_new(TINKER_TYPE_WELCOME, NULL);
    welcome->document = g_object_ref(document);
    welcome->player = g_object_ref(player);
    g_signal_connect_object(document, "changed", G_CALLBACK(update), welcome, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(update), welcome, G_CONNECT_SWAPPED);
    g_signal_connect_object(overlay, "get-child-position", G_CALLBACK(on_placed), welcome, 0);
    gtk_overlay_add_overlay(overlay, GTK_WIDGET(welcome));
    g_signal_connect_object(gtk_overlay_get_child(overlay), "panels", G_CALLBACK(add_panel), welcome,
                            G_CONNECT_SWAPPED);
    update(welcome);
}
