/* The examples are the first of each topic. Their pictures are painted one at a time when there is nothing else to do,
 * so that the window is there first; and anew where the desktop goes dark. */
#include "gui/window/welcome.h"

#include <adwaita.h>
#include <glib/gi18n.h>

#include "gui/document/examples.h"
#include "gui/text/translate.h"
#include "gui/widget/unparent.h"
#include "render/picture/painter.h"

#define SHOWN_EXAMPLES 4
#define CARD_WIDTH     660
#define PICTURE_WIDTH  136
#define PICTURE_HEIGHT 96
#define PICTURE_FACTOR 2 /* painted finer than shown, for screens with small pixels */
#define PICTURE_MARGIN 10.0

struct _TinkerWelcome {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    GtkWidget *examples;
    guint painter; /* id of the idle source, or 0 */
    guint painted; /* pictures so far */
    GtkWidget *pictures[SHOWN_EXAMPLES];
    const TinkerExample *shown[SHOWN_EXAMPLES];
    guint count;
};

G_DEFINE_FINAL_TYPE(TinkerWelcome, tinker_welcome, GTK_TYPE_WIDGET)

/* Pictures ------------------------------------------------------------------------------------------------------------
 */

static GdkTexture *texture_of(cairo_surface_t *surface)
{
    int width = cairo_image_surface_get_width(surface), height = cairo_image_surface_get_height(surface);
    gsize stride = (gsize)cairo_image_surface_get_stride(surface);
    cairo_surface_flush(surface);
    g_autoptr(GBytes) bytes = g_bytes_new_with_free_func(cairo_image_surface_get_data(surface), stride * (gsize)height,
                                                         (GDestroyNotify)cairo_surface_destroy, surface);
    return gdk_memory_texture_new(width, height, GDK_MEMORY_DEFAULT, bytes, stride);
}

/* NULL where the scene cannot be read or drawn. (transfer full) */
static GdkTexture *paint_example(TinkerCatalogue *catalogue, const char *path)
{
    g_autoptr(TinkerScene) scene = tinker_scene_read_file(catalogue, path, NULL, NULL);
    if (scene == NULL) return NULL;
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    if (frame == NULL) return NULL;
    TinkerPaintOptions options = tinker_paint_options_default();
    gboolean dark = adw_style_manager_get_dark(adw_style_manager_get_default());
    options.theme = tinker_theme_find(dark ? "dark" : "light");
    options.show_grid = options.show_labels = FALSE;
    double box[4];
    tinker_painter_bounds(frame, box);
    TinkerView view = tinker_view_fit(box, PICTURE_WIDTH, PICTURE_HEIGHT, PICTURE_MARGIN);
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, PICTURE_WIDTH * PICTURE_FACTOR,
                                                          PICTURE_HEIGHT * PICTURE_FACTOR);
    cairo_surface_set_device_scale(surface, PICTURE_FACTOR, PICTURE_FACTOR);
    cairo_t *cairo = cairo_create(surface);
    tinker_paint_scene(cairo, frame, &view, &options);
    cairo_destroy(cairo);
    return texture_of(surface);
}

static gboolean paint_next(gpointer data)
{
    TinkerWelcome *welcome = data;
    if (welcome->painted >= welcome->count) {
        welcome->painter = 0;
        return G_SOURCE_REMOVE;
    }
    guint number = welcome->painted++;
    g_autoptr(GdkTexture) texture =
        paint_example(tinker_document_catalogue(welcome->document), welcome->shown[number]->path);
    if (texture != NULL) gtk_picture_set_paintable(GTK_PICTURE(welcome->pictures[number]), GDK_PAINTABLE(texture));
    return G_SOURCE_CONTINUE;
}

static void paint_pictures(TinkerWelcome *welcome)
{
    welcome->painted = 0;
    if (welcome->painter == 0 && gtk_widget_get_mapped(GTK_WIDGET(welcome)))
        welcome->painter = g_idle_add_full(G_PRIORITY_LOW, paint_next, welcome, NULL);
}

/* The card ------------------------------------------------------------------------------------------------------------
 */

static GtkWidget *example_button(TinkerWelcome *welcome, guint number)
{
    const TinkerExample *example = welcome->shown[number];
    GtkWidget *button = gtk_button_new(), *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 6);
    GtkWidget *picture = gtk_picture_new(), *label = gtk_label_new(tinker_translate(example->title));
    gtk_widget_set_size_request(picture, PICTURE_WIDTH, PICTURE_HEIGHT);
    gtk_picture_set_can_shrink(GTK_PICTURE(picture), TRUE);
    gtk_widget_set_overflow(picture, GTK_OVERFLOW_HIDDEN);
    gtk_widget_add_css_class(picture, "welcome-picture");
    gtk_label_set_ellipsize(GTK_LABEL(label), PANGO_ELLIPSIZE_END);
    gtk_label_set_max_width_chars(GTK_LABEL(label), 1);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_label_set_lines(GTK_LABEL(label), 2);
    gtk_label_set_justify(GTK_LABEL(label), GTK_JUSTIFY_CENTER);
    gtk_label_set_yalign(GTK_LABEL(label), 0);
    gtk_widget_set_vexpand(label, TRUE);
    gtk_widget_set_hexpand(label, TRUE);
    gtk_box_append(GTK_BOX(box), picture);
    gtk_box_append(GTK_BOX(box), label);
    gtk_button_set_child(GTK_BUTTON(button), box);
    gtk_widget_add_css_class(button, "flat");
    gtk_widget_add_css_class(button, "welcome-example");
    gtk_widget_set_tooltip_text(button, example->description);
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL,
                                   tinker_translate(example->title), -1);
    gtk_actionable_set_action_name(GTK_ACTIONABLE(button), "win.open-example");
    gtk_actionable_set_action_target(GTK_ACTIONABLE(button), "s", example->path);
    welcome->pictures[number] = picture;
    return button;
}

/* The first of each topic, for they are unlike one another. Not before the card is shown: the files of all examples are
 * read for it. */
static void add_examples(TinkerWelcome *welcome)
{
    const GPtrArray *topics = tinker_examples(tinker_document_catalogue(welcome->document));
    if (welcome->count > 0) return;
    for (guint t = 0; t < topics->len && welcome->count < SHOWN_EXAMPLES; t++) {
        const TinkerTopic *topic = g_ptr_array_index(topics, t);
        welcome->shown[welcome->count] = g_ptr_array_index(topic->examples, 0);
        gtk_box_append(GTK_BOX(welcome->examples), example_button(welcome, welcome->count));
        welcome->count++;
    }
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
    gtk_box_append(GTK_BOX(card), label_new(_("Or Open an Example"), "heading"));
    welcome->examples = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6);
    gtk_box_set_homogeneous(GTK_BOX(welcome->examples), TRUE);
    gtk_box_append(GTK_BOX(card), welcome->examples);
    return card;
}

/* When it is shown ----------------------------------------------------------------------------------------------------
 */

static void update(TinkerWelcome *welcome)
{
    gboolean idle = tinker_player_state(welcome->player) == TINKER_PLAYER_SETUP;
    gtk_widget_set_visible(GTK_WIDGET(welcome), idle && tinker_document_is_empty(welcome->document));
}

static gboolean prepare(gpointer data)
{
    TinkerWelcome *welcome = data;
    welcome->painter = 0;
    add_examples(welcome);
    paint_pictures(welcome);
    return G_SOURCE_REMOVE;
}

static void tinker_welcome_map(GtkWidget *widget)
{
    TinkerWelcome *welcome = TINKER_WELCOME(widget);
    GTK_WIDGET_CLASS(tinker_welcome_parent_class)->map(widget);
    if (welcome->painter == 0 && welcome->painted == 0)
        welcome->painter = g_idle_add_full(G_PRIORITY_LOW, prepare, welcome, NULL);
}

static void tinker_welcome_dispose(GObject *object)
{
    TinkerWelcome *welcome = TINKER_WELCOME(object);
    g_clear_handle_id(&welcome->painter, g_source_remove);
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
    GtkWidget *clamp = adw_clamp_new();
    adw_clamp_set_maximum_size(ADW_CLAMP(clamp), CARD_WIDTH);
    adw_clamp_set_tightening_threshold(ADW_CLAMP(clamp), CARD_WIDTH);
    adw_clamp_set_child(ADW_CLAMP(clamp), card_new(welcome));
    gtk_widget_set_parent(clamp, GTK_WIDGET(welcome));
    gtk_widget_set_halign(GTK_WIDGET(welcome), GTK_ALIGN_CENTER);
    gtk_widget_set_valign(GTK_WIDGET(welcome), GTK_ALIGN_CENTER);
    gtk_widget_set_margin_bottom(GTK_WIDGET(welcome), 48); /* the play bar's */
    gtk_accessible_update_property(GTK_ACCESSIBLE(welcome), GTK_ACCESSIBLE_PROPERTY_LABEL, _("First Steps"), -1);
}

GtkWidget *tinker_welcome_new(TinkerDocument *document, TinkerPlayer *player)
{
    TinkerWelcome *welcome = g_object_new(TINKER_TYPE_WELCOME, NULL);
    welcome->document = g_object_ref(document);
    welcome->player = g_object_ref(player);
    g_signal_connect_object(document, "changed", G_CALLBACK(update), welcome, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(update), welcome, G_CONNECT_SWAPPED);
    g_signal_connect_object(adw_style_manager_get_default(), "notify::dark", G_CALLBACK(paint_pictures), welcome,
                            G_CONNECT_SWAPPED);
    update(welcome);
    return GTK_WIDGET(welcome);
}
