/* The list is filled anew after every change of the scene. Quantities of the chosen block follow it. */
#include "gui/graph/curves-dialog.h"

#include <adwaita.h>
#include <glib/gi18n.h>
#include <string.h>

#include "gui/curve/graph-edit.h"
#include "gui/graph/table-dialog.h"
#include "gui/text/sentence.h"
#include "gui/text/translate.h"
#include "gui/widget/choices.h"
#include "scene/store/quantities.h"

#define WIDTH       540
#define HEIGHT      440
#define LIST_HEIGHT 170 /* of more curves than that has room for, some are scrolled to: more can always be added */

typedef struct {
    TinkerDocument *document;
    int number;
    GtkWindow *window;
    GtkWidget *list, *block, *quantity, *expression, *across, *upwards, *fault;
    GStrv quantities; /* those that are listed, by their names in files */
    gboolean filling;
} Dialog;

static void dialog_free(gpointer data)
{
    Dialog *dialog = data;
    g_object_unref(dialog->document);
    g_strfreev(dialog->quantities);
    g_free(dialog);
}

static const TinkerSceneGraph *graph_of(const Dialog *dialog)
{
    GPtrArray *graphs = tinker_scene_graphs(tinker_document_scene(dialog->document));
    return dialog->number < (int)graphs->len ? g_ptr_array_index(graphs, dialog->number) : NULL;
}

/* Behind where the message says that it is. */
static const char *past(const char *message, const char *place)
{
    return g_str_has_prefix(message, place) ? message + strlen(place) : message;
}

/* What is wrong, if anything, as a sentence; where it is in the expression, the cursor is put. */
static void tell(Dialog *dialog, GError *error)
{
    g_autofree char *sentence = NULL;
    int column = 0;
    if (error != NULL) {
        const char *bare = past(past(error->message, "graph: "), "expression: ");
        sentence = tinker_sentence_in(tinker_document_scene(dialog->document), tinker_without_column(bare, &column));
    }
    gtk_label_set_text(GTK_LABEL(dialog->fault), sentence != NULL ? sentence : "");
    gtk_widget_set_visible(dialog->fault, sentence != NULL);
    if (column == 0) return;
    gtk_widget_grab_focus(dialog->expression);
    gtk_editable_set_position(GTK_EDITABLE(dialog->expression), column - 1);
}

/* The list --------------------------------------------------------------------------------------------------------- */

static char *name_of(const TinkerSceneCurve *curve)
{
    if (curve->title != NULL) return g_strdup(curve->title);
    if (curve->expression != NULL) return g_strdup(curve->expression);
    if (curve->table != NULL) return g_strdup_printf("%s, %d", curve->table, curve->column);
    return g_strdup_printf("%s.%s", curve->block, curve->quantity);
}

static guint curve_of(GtkWidget *widget)
{
    return GPOINTER_TO_UINT(g_object_get_data(G_OBJECT(widget), "curve"));
}

static void on_axis(GtkWidget *chooser, GParamSpec *spec, Dialog *dialog)
{
    g_autoptr(GError) error = NULL;
    const int axis = gtk_drop_down_get_selected(GTK_DROP_DOWN(chooser)) == 1 ? 2 : 1;
    if (dialog->filling) return;
    tinker_graph_set_curve_axis(dialog->document, dialog->number, curve_of(chooser), axis, &error);
    tell(dialog, error);
}

static void on_remove(GtkWidget *button, Dialog *dialog)
{
    g_autoptr(GError) error = NULL;
    tinker_graph_remove_curve(dialog->document, dialog->number, curve_of(button), &error);
    tell(dialog, error);
}

static void add_row(Dialog *dialog, const TinkerSceneCurve *curve, guint number, gboolean lone)
{
    static const char *const axes[] = {N_("Left Axis"), N_("Right Axis"), NULL};
    const char *const shown[] = {_(axes[0]), _(axes[1]), NULL};
    g_autofree char *name = name_of(curve), *of_axis = g_strdup_printf(_("Axis of %s"), name),
                    *of_button = g_strdup_printf(_("Remove %s"), name);
    GtkWidget *row = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6), *label = gtk_label_new(name);
    GtkWidget *axis = gtk_drop_down_new_from_strings(shown);
    GtkWidget *button = gtk_button_new_from_icon_name("list-remove-symbolic");
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_ellipsize(GTK_LABEL(label), PANGO_ELLIPSIZE_END);
    gtk_widget_set_hexpand(label, TRUE);
    gtk_widget_set_tooltip_text(label, name);
    gtk_widget_set_tooltip_text(button, of_button);
    gtk_widget_add_css_class(button, "flat");
    gtk_widget_set_sensitive(button, !lone);
    gtk_drop_down_set_selected(GTK_DROP_DOWN(axis), curve->axis == 2 ? 1 : 0);
    gtk_accessible_update_property(GTK_ACCESSIBLE(axis), GTK_ACCESSIBLE_PROPERTY_LABEL, of_axis, -1);
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, of_button, -1);
    GtkWidget *parts[] = {label, axis, button};
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++) {
        g_object_set_data(G_OBJECT(parts[i]), "curve", GUINT_TO_POINTER(number));
        gtk_box_append(GTK_BOX(row), parts[i]);
    }
    g_signal_connect(axis, "notify::selected", G_CALLBACK(on_axis), dialog);
    g_signal_connect(button, "clicked", G_CALLBACK(on_remove), dialog);
    gtk_box_append(GTK_BOX(dialog->list), row);
}

static gboolean fill(gpointer window)
{
    Dialog *dialog = g_object_get_data(window, "dialog");
    const TinkerSceneGraph *graph = graph_of(dialog);
    if (graph == NULL) return G_SOURCE_REMOVE;
    dialog->filling = TRUE;
    GtkWidget *child;
    while ((child = gtk_widget_get_first_child(dialog->list)) != NULL)
        gtk_box_remove(GTK_BOX(dialog->list), child);
    for (guint i = 0; i < graph->curves->len; i++)
        add_row(dialog, g_ptr_array_index(graph->curves, i), i, graph->curves->len == 1);
    gtk_check_button_set_active(GTK_CHECK_BUTTON(dialog->across), graph->logarithmic[0]);
    gtk_check_button_set_active(GTK_CHECK_BUTTON(dialog->upwards), graph->logarithmic[1]);
    dialog->filling = FALSE;
    return G_SOURCE_REMOVE;
}

/* Later: what tells of the change may be a part of the list. */
static void on_changed(GtkWindow *window)
{
    g_idle_add_full(G_PRIORITY_HIGH_IDLE, fill, g_object_ref(window), g_object_unref);
}

/* More ------------------------------------------------------------------------------------------------------------- */

static gboolean add(Dialog *dialog, const TinkerSceneCurve *curve)
{
    g_autoptr(GError) error = NULL;
    const gboolean added = tinker_graph_add_curve(dialog->document, dialog->number, curve, &error);
    tell(dialog, error);
    return added;
}

static const char *chosen(GtkWidget *list)
{
    GObject *item = gtk_drop_down_get_selected_item(GTK_DROP_DOWN(list));
    return item != NULL ? gtk_string_object_get_string(GTK_STRING_OBJECT(item)) : NULL;
}

static void offer(GtkStringList *model, GStrvBuilder *names, TinkerScene *scene, TinkerBlockId block, const char *name)
{
    const int32_t number = tinker_scene_find_quantity(scene, block, name);
    if (number < 0) return; /* "distance to BLOCK" stands for as many as there are blocks */
    g_strv_builder_add(names, name);
    gtk_string_list_append(model, tinker_translate(tinker_scene_quantity_type(scene, block, number).title));
}

static void on_block(Dialog *dialog)
{
    TinkerScene *scene = tinker_document_scene(dialog->document);
    TinkerBlockId block;
    if (chosen(dialog->block) == NULL || !tinker_scene_find_owner(scene, chosen(dialog->block), &block)) return;
    g_autoptr(GtkStringList) model = gtk_string_list_new(NULL);
    g_autoptr(GStrvBuilder) names = g_strv_builder_new();
    g_auto(GStrv) of_class = tinker_scene_quantity_names(scene, block);
    for (char **name = of_class; *name != NULL; name++)
        offer(model, names, scene, block, *name);
    for (int32_t i = 0; block != TINKER_NO_BLOCK && i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId other = tinker_scene_block_at(scene, i);
        g_autofree char *distance = tinker_quantity_distance_to(tinker_scene_block_name(scene, other));
        if (other != block) offer(model, names, scene, block, distance);
    }
    g_strfreev(dialog->quantities);
    dialog->quantities = g_strv_builder_end(names);
    gtk_drop_down_set_model(GTK_DROP_DOWN(dialog->quantity), G_LIST_MODEL(model));
}

/* With a unit of its own a curve goes to the other axis. */
static void on_add_quantity(Dialog *dialog)
{
    const guint place = gtk_drop_down_get_selected(GTK_DROP_DOWN(dialog->quantity));
    TinkerSceneCurve curve = {.block = (char *)chosen(dialog->block), .axis = 1};
    const TinkerSceneCurve *first = tinker_scene_graph_curve(graph_of(dialog));
    TinkerScene *scene = tinker_document_scene(dialog->document);
    TinkerBlockId mine, its;
    if (curve.block == NULL || place == GTK_INVALID_LIST_POSITION) return;
    curve.quantity = dialog->quantities[place];
    if (first != NULL && tinker_scene_find_owner(scene, first->block, &its) &&
        tinker_scene_find_owner(scene, curve.block, &mine)) {
        const int32_t a = tinker_scene_find_quantity(scene, its, first->quantity),
                      b = tinker_scene_find_quantity(scene, mine, curve.quantity);
        if (a >= 0 && b >= 0 &&
            !tinker_dimension_equal(tinker_scene_quantity_type(scene, its, a).dimension,
                                    tinker_scene_quantity_type(scene, mine, b).dimension))
            curve.axis = 2;
    }
    add(dialog, &curve);
}

static void on_add_expression(Dialog *dialog)
{
    const TinkerSceneCurve curve = {.expression = (char *)gtk_editable_get_text(GTK_EDITABLE(dialog->expression)),
                                    .axis = 1};
    if (curve.expression[0] != '\0' && add(dialog, &curve)) gtk_editable_set_text(GTK_EDITABLE(dialog->expression), "");
}

static void on_told(GtkWindow *window, GError *error)
{
    tell(g_object_get_data(G_OBJECT(window), "dialog"), error);
}

static void on_add_table(Dialog *dialog)
{
    tinker_table_dialog_open(dialog->window, dialog->document, dialog->number, on_told);
}

static void on_scale(GtkWidget *button, Dialog *dialog)
{
    g_autoptr(GError) error = NULL;
    const gboolean active = gtk_check_button_get_active(GTK_CHECK_BUTTON(button));
    if (dialog->filling) return;
    tinker_graph_set_logarithmic(dialog->document, dialog->number, button == dialog->upwards, active, &error);
    tell(dialog, error);
}

/* The window ------------------------------------------------------------------------------------------------------- */

static GtkWidget *add_line(GtkWidget *box)
{
    GtkWidget *line = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6);
    gtk_box_append(GTK_BOX(box), line);
    return line;
}

static void add_button(GtkWidget *line, const char *label, Dialog *dialog, GCallback clicked)
{
    GtkWidget *button = gtk_button_new_with_mnemonic(label);
    gtk_box_append(GTK_BOX(line), button);
    g_signal_connect_swapped(button, "clicked", clicked, dialog);
}

static GtkWidget *add_choices(GtkWidget *line, const char *label, GListModel *model)
{
    GtkWidget *list = gtk_drop_down_new(model, NULL);
    tinker_choices_cut_off(GTK_DROP_DOWN(list));
    gtk_widget_set_hexpand(list, TRUE);
    gtk_accessible_update_property(GTK_ACCESSIBLE(list), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    gtk_box_append(GTK_BOX(line), list);
    return list;
}

static GListModel *owners_of(TinkerScene *scene)
{
    GtkStringList *names = gtk_string_list_new(NULL);
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++)
        gtk_string_list_append(names, tinker_scene_block_name(scene, tinker_scene_block_at(scene, i)));
    gtk_string_list_append(names, tinker_scene_owner_name(scene, TINKER_NO_BLOCK));
    return G_LIST_MODEL(names);
}

/* The next curve most often is of the block that the first one is of. */
static void choose_first_owner(Dialog *dialog)
{
    const TinkerSceneCurve *first = tinker_scene_graph_curve(graph_of(dialog));
    GListModel *owners = gtk_drop_down_get_model(GTK_DROP_DOWN(dialog->block));
    for (guint i = 0; first != NULL && first->block != NULL && i < g_list_model_get_n_items(owners); i++)
        if (strcmp(gtk_string_list_get_string(GTK_STRING_LIST(owners), i), first->block) == 0)
            gtk_drop_down_set_selected(GTK_DROP_DOWN(dialog->block), i);
}

static void add_parts(Dialog *dialog, GtkWidget *box)
{
    GtkWidget *scroller = gtk_scrolled_window_new();
    dialog->list = gtk_box_new(GTK_ORIENTATION_VERTICAL, 6);
    g_object_set(scroller, "hscrollbar-policy", GTK_POLICY_NEVER, "propagate-natural-height", TRUE,
                 "max-content-height", LIST_HEIGHT, "child", dialog->list, NULL);
    gtk_box_append(GTK_BOX(box), scroller);
    gtk_box_append(GTK_BOX(box), gtk_separator_new(GTK_ORIENTATION_HORIZONTAL));
    GtkWidget *line = add_line(box);
    dialog->block = add_choices(line, _("Block"), owners_of(tinker_document_scene(dialog->document)));
    dialog->quantity = add_choices(line, _("Quantity"), NULL);
    add_button(line, _("_Add"), dialog, G_CALLBACK(on_add_quantity));
    choose_first_owner(dialog);
    g_signal_connect_swapped(dialog->block, "notify::selected", G_CALLBACK(on_block), dialog);
    on_block(dialog);
    line = add_line(box);
    dialog->expression = gtk_entry_new();
    gtk_widget_set_hexpand(dialog->expression, TRUE);
    gtk_entry_set_placeholder_text(GTK_ENTRY(dialog->expression), _("Expression, as 0.5*{Mass 0.mass}*{Mass 0.vx}^2"));
    gtk_accessible_update_property(GTK_ACCESSIBLE(dialog->expression), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Expression"),
                                   -1);
    gtk_box_append(GTK_BOX(line), dialog->expression);
    g_signal_connect_swapped(dialog->expression, "activate", G_CALLBACK(on_add_expression), dialog);
    add_button(line, _("Add _Expression"), dialog, G_CALLBACK(on_add_expression));
    dialog->fault = g_object_new(GTK_TYPE_LABEL, "accessible-role", GTK_ACCESSIBLE_ROLE_ALERT, "wrap", TRUE, "xalign",
                                 0.0, "visible", FALSE, NULL);
    gtk_widget_add_css_class(dialog->fault, "error");
    gtk_box_append(GTK_BOX(box), dialog->fault);
    line = add_line(box);
    add_button(line, _("Add _Table…"), dialog, G_CALLBACK(on_add_table));
    dialog->across = gtk_check_button_new_with_label(_("Logarithmic Across"));
    dialog->upwards = gtk_check_button_new_with_label(_("Logarithmic Upwards"));
    line = add_line(box);
    GtkWidget *scales[] = {dialog->across, dialog->upwards};
    for (gsize i = 0; i < G_N_ELEMENTS(scales); i++) {
        gtk_box_append(GTK_BOX(line), scales[i]);
        g_signal_connect(scales[i], "toggled", G_CALLBACK(on_scale), dialog);
    }
}

static gboolean on_escape(GtkWidget *widget, GVariant *arguments, gpointer data)
{
    gtk_window_close(GTK_WINDOW(widget));
    return TRUE;
}

void tinker_curves_dialog_open(GtkWidget *over, TinkerDocument *document, int number)
{
    Dialog *dialog = g_new0(Dialog, 1);
    GtkRoot *root = gtk_widget_get_root(over);
    GtkWidget *content = gtk_box_new(GTK_ORIENTATION_VERTICAL, 0), *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, 12);
    GtkWidget *scroller = gtk_scrolled_window_new();
    dialog->document = g_object_ref(document);
    dialog->number = number;
    dialog->window =
        g_object_new(ADW_TYPE_WINDOW, "title", _("Curves of the Graph"), "modal", TRUE, "transient-for", root,
                     "default-width", WIDTH, "default-height", HEIGHT, "destroy-with-parent", TRUE, NULL);
    g_object_set_data_full(G_OBJECT(dialog->window), "dialog", dialog, dialog_free);
    g_object_set(box, "margin-top", 12, "margin-bottom", 18, "margin-start", 18, "margin-end", 18, NULL);
    add_parts(dialog, box);
    g_object_set(scroller, "hscrollbar-policy", GTK_POLICY_NEVER, "propagate-natural-height", TRUE, "vexpand", TRUE,
                 "child", box, NULL);
    gtk_box_append(GTK_BOX(content), adw_header_bar_new());
    gtk_box_append(GTK_BOX(content), scroller);
    adw_window_set_content(ADW_WINDOW(dialog->window), content);
    GtkEventController *keys = gtk_shortcut_controller_new();
    gtk_shortcut_controller_add_shortcut(
        GTK_SHORTCUT_CONTROLLER(keys),
        gtk_shortcut_new(gtk_keyval_trigger_new(GDK_KEY_Escape, 0), gtk_callback_action_new(on_escape, NULL, NULL)));
    gtk_widget_add_controller(GTK_WIDGET(dialog->window), keys);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), dialog->window, G_CONNECT_SWAPPED);
    fill(dialog->window);
    gtk_window_present(dialog->window);
}
