/* Texts of the scene come from its head, those about the model from the plan, which is asked for when the card is
 * looked at. */
#include "gui/window/scene-card.h"

#include <glib/gi18n.h>

#include "gui/text/translate.h"
#include "gui/widget/unparent.h"

struct _TinkerSceneCard {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPlanTask *plan;
    GtkWidget *title, *description, *scope;
};

G_DEFINE_FINAL_TYPE(TinkerSceneCard, tinker_scene_card, GTK_TYPE_WIDGET)

static void show_text(GtkWidget *label, const char *text)
{
    gtk_label_set_text(GTK_LABEL(label), text);
    gtk_widget_set_visible(label, *text != '\0');
}

static void on_changed(TinkerSceneCard *card)
{
    const TinkerSceneHead *head = tinker_scene_head(tinker_document_scene(card->document));
    const gboolean told = *head->description != '\0';
    show_text(card->title, tinker_translate_title(head->title, head->description));
    show_text(card->description, told ? tinker_translate(head->description)
                                      : _("This scene has no description. It is written under Properties, Scene."));
    if (told)
        gtk_widget_remove_css_class(card->description, "dim-label");
    else
        gtk_widget_add_css_class(card->description, "dim-label");
}

/* What is modelled
 * -------------------------------------------------------------------------------------------------------- */

static void add_sentences(GString *text, const char *heading, const GPtrArray *sentences)
{
    if (sentences->len == 0) return;
    g_string_append_printf(text, "%s<b>%s</b>", text->len > 0 ? "\n\n" : "", heading);
    for (guint i = 0; i < sentences->len; i++) {
        g_autofree char *markup = g_markup_escape_text(g_ptr_array_index(sentences, i), -1);
        g_string_append_printf(text, "\n• %s", markup);
    }
}

static void on_plan_changed(TinkerSceneCard *card)
{
    const TinkerPlanResult *result = tinker_plan_task_result(card->plan);
    g_autoptr(GString) text = g_string_new(NULL);
    if (result != NULL && result->plan != NULL) {
        add_sentences(text, _("Modelled"), result->plan->modelled);
        add_sentences(text, _("Left out"), result->plan->left_out);
    } else if (result != NULL && result->error != NULL) {
        g_autofree char *markup = g_markup_escape_text(result->error->message, -1);
        g_string_append(text, markup);
    }
    gtk_label_set_markup(GTK_LABEL(card->scope), text->str);
    if (gtk_widget_get_mapped(GTK_WIDGET(card))) tinker_plan_task_demand(card->plan);
}

static void tinker_scene_card_map(GtkWidget *widget)
{
    GTK_WIDGET_CLASS(tinker_scene_card_parent_class)->map(widget);
    tinker_plan_task_demand(TINKER_SCENE_CARD(widget)->plan);
}

/* Life ------------------------------------------------------------------------------------------------------------- */

static GtkWidget *add_label(GtkWidget *box, const char *css_class)
{
    GtkWidget *label = gtk_label_new(NULL);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_label_set_wrap_mode(GTK_LABEL(label), PANGO_WRAP_WORD_CHAR);
    gtk_label_set_max_width_chars(GTK_LABEL(label), 1);
    gtk_label_set_selectable(GTK_LABEL(label), TRUE);
    gtk_widget_set_can_focus(label, FALSE); /* else the first one would be selected as the card comes up */
    if (css_class != NULL) gtk_widget_add_css_class(label, css_class);
    gtk_box_append(GTK_BOX(box), label);
    return label;
}

static GtkWidget *new_card(void)
{
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 6);
    gtk_widget_add_css_class(box, "card");
    gtk_widget_add_css_class(box, "scene-card");
    return box;
}

static void tinker_scene_card_init(TinkerSceneCard *card)
{
    GtkLayoutManager *layout = gtk_widget_get_layout_manager(GTK_WIDGET(card));
    gtk_orientable_set_orientation(GTK_ORIENTABLE(layout), GTK_ORIENTATION_VERTICAL);
    gtk_box_layout_set_spacing(GTK_BOX_LAYOUT(layout), 12);
    GtkWidget *about = new_card(), *model = new_card();
    card->title = add_label(about, "heading");
    card->description = add_label(about, NULL);
    gtk_label_set_text(GTK_LABEL(add_label(model, "heading")), _("What Is Modelled"));
    card->scope = add_label(model, NULL);
    gtk_widget_set_parent(about, GTK_WIDGET(card));
    gtk_widget_set_parent(model, GTK_WIDGET(card));
}

GtkWidget *tinker_scene_card_new(TinkerDocument *document, TinkerPlanTask *plan)
{
    TinkerSceneCard *card = g_object_new(TINKER_TYPE_SCENE_CARD, NULL);
    card->document = g_object_ref(document);
    card->plan = g_object_ref(plan);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), card, G_CONNECT_SWAPPED);
    g_signal_connect_object(plan, "changed", G_CALLBACK(on_plan_changed), card, G_CONNECT_SWAPPED);
    on_changed(card);
    on_plan_changed(card);
    return GTK_WIDGET(card);
}

static void tinker_scene_card_dispose(GObject *object)
{
    TinkerSceneCard *card = TINKER_SCENE_CARD(object);
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_object(&card->plan);
    g_clear_object(&card->document);
    G_OBJECT_CLASS(tinker_scene_card_parent_class)->dispose(object);
}

static void tinker_scene_card_class_init(TinkerSceneCardClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_scene_card_dispose;
    GTK_WIDGET_CLASS(class)->map = tinker_scene_card_map;
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BOX_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "scenecard");
}
