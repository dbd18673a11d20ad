/* Groups that can be closed, with a field for each row of the property list. What changes is put into the fields there
 * are, so that the focus and what is being typed stay; fields are made and taken away only where the list has other
 * rows. */
#include "gui/property/property-panel.h"

#include <glib/gi18n.h>

#include "common/overlay/motion-vectors.h"
#include "gui/property/property-field.h"
#include "gui/widget/unparent.h"

#define REFRESH_INTERVAL 50  /* ms: live values need not be faster */
#define MOST_BODIES      200 /* of a scene whose modes are worked out for a line beside a frequency */

typedef struct {
    GtkWidget *expander, *fields;
    guint stamp; /* of the last list that it was in */
} Group;

typedef struct {
    GtkWidget *field;
    guint stamp;
} Field;

struct _TinkerPropertyPanel {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    GtkWidget *heading, *groups, *nothing;
    GHashTable *group_of; /* title to Group */
    GHashTable *field_of; /* id of a row to Field */
    GHashTable *closed;   /* titles of groups that are closed */
    guint stamp;
    guint refresh; /* id of the source that will refresh it, or 0 */
    gint64 last;   /* us: when it was refreshed */
    gboolean trims;
    TinkerModesTask *modes;
    gboolean wants_modes;
    gboolean focus;   /* the next time it is refreshed it takes the focus, */
    char *focused_id; /* with this row, NULL: the first */
};

G_DEFINE_FINAL_TYPE(TinkerPropertyPanel, tinker_property_panel, GTK_TYPE_WIDGET)

enum { PROP_TRIMS = 1 };

/* Groups ----------------------------------------------------------------------------------------------------------- */

static void on_expanded(GtkExpander *expander, GParamSpec *spec, TinkerPropertyPanel *panel)
{
    const char *title = gtk_expander_get_label(expander);
    if (gtk_expander_get_expanded(expander))
        g_hash_table_remove(panel->closed, title);
    else
        g_hash_table_add(panel->closed, g_strdup(title));
}

static Group *add_group(TinkerPropertyPanel *panel, const char *title)
{
    Group *group = g_new0(Group, 1);
    group->expander = gtk_expander_new(title);
    group->fields = gtk_box_new(GTK_ORIENTATION_VERTICAL, 4);
    gtk_expander_set_child(GTK_EXPANDER(group->expander), group->fields);
    gtk_expander_set_expanded(GTK_EXPANDER(group->expander), !g_hash_table_contains(panel->closed, title));
    gtk_accessible_update_property(GTK_ACCESSIBLE(group->expander), GTK_ACCESSIBLE_PROPERTY_LABEL, title, -1);
    g_signal_connect(group->expander, "notify::expanded", G_CALLBACK(on_expanded), panel);
    gtk_box_append(GTK_BOX(panel->groups), group->expander);
    g_hash_table_insert(panel->group_of, g_strdup(title), group);
    return group;
}

static Field *add_field(TinkerPropertyPanel *panel, Group *group, TinkerPropertyRow *row)
{
    Field *field = g_new0(Field, 1);
    field->field = tinker_property_field_new(panel->document, row);
    gtk_box_append(GTK_BOX(group->fields), field->field);
    g_hash_table_insert(panel->field_of, g_strdup(row->id), field);
    return field;
}

/* Behind `last`, or first. */
static void put_behind(GtkWidget *widget, GtkWidget *last)
{
    if (gtk_widget_get_prev_sibling(widget) != last)
        gtk_box_reorder_child_after(GTK_BOX(gtk_widget_get_parent(widget)), widget, last);
}

/* Takes away what was not in the list of this stamp: fields before the groups that they are in. */
static void remove_others(TinkerPropertyPanel *panel)
{
    GHashTableIter iter;
    gpointer value;
    g_hash_table_iter_init(&iter, panel->field_of);
    while (g_hash_table_iter_next(&iter, NULL, &value)) {
        Field *field = value;
        if (field->stamp == panel->stamp) continue;
        gtk_box_remove(GTK_BOX(gtk_widget_get_parent(field->field)), field->field);
        g_hash_table_iter_remove(&iter);
    }
    g_hash_table_iter_init(&iter, panel->group_of);
    while (g_hash_table_iter_next(&iter, NULL, &value)) {
        Group *group = value;
        if (group->stamp == panel->stamp) continue;
        gtk_box_remove(GTK_BOX(panel->groups), group->expander);
        g_hash_table_iter_remove(&iter);
    }
}

/* Refreshing ------------------------------------------------------------------------------------------------------- */

static void show_rows(TinkerPropertyPanel *panel, GPtrArray *rows)
{
    GtkWidget *last_group = NULL, *last_field = NULL;
    panel->stamp++;
    for (guint i = 0; i < rows->len; i++) {
        TinkerPropertyRow *row = g_ptr_array_index(rows, i);
        Group *group = g_hash_table_lookup(panel->group_of, row->group);
        if (group == NULL) group = add_group(panel, row->group);
        if (group->stamp != panel->stamp) {
            group->stamp = panel->stamp;
            put_behind(group->expander, last_group);
            last_group = group->expander;
            last_field = NULL;
        }
        Field *field = g_hash_table_lookup(panel->field_of, row->id);
        if (field == NULL)
            field = add_field(panel, group, row);
        else
            tinker_property_field_show(TINKER_PROPERTY_FIELD(field->field), row);
        field->stamp = panel->stamp;
        put_behind(field->field, last_field);
        last_field = field->field;
    }
    remove_others(panel);
}

static gboolean is_small(TinkerScene *scene)
{
    int bodies = 0;
    for (int32_t place = 0; place < tinker_scene_block_count(scene) && bodies <= MOST_BODIES; place++)
        bodies += tinker_block_moves(scene, tinker_scene_block_at(scene, place));
    return bodies <= MOST_BODIES;
}

static void want_modes(TinkerPropertyPanel *panel, gboolean wanted)
{
    if (wanted == panel->wants_modes) return;
    panel->wants_modes = wanted;
    tinker_modes_task_want(panel->modes, wanted);
}

/* Modes are worked out while a frequency that drives the scene is shown. */
static void hint_resonances(TinkerPropertyPanel *panel, GPtrArray *rows)
{
    TinkerScene *scene = tinker_document_scene(panel->document);
    if (panel->modes == NULL) return;
    const TinkerModesResult *result = tinker_modes_task_result(panel->modes);
    const gboolean any = tinker_property_list_hint_resonances(rows, scene, result != NULL ? result->responses : NULL);
    want_modes(panel, any && is_small(scene));
}

static void refresh(TinkerPropertyPanel *panel)
{
    if (!gtk_widget_get_mapped(GTK_WIDGET(panel))) return;
    g_autoptr(GPtrArray) rows = tinker_property_list_new(panel->document, panel->player, panel->trims);
    hint_resonances(panel, rows);
    g_autofree char *heading = tinker_property_list_heading(panel->document);
    gtk_label_set_text(GTK_LABEL(panel->heading), heading);
    show_rows(panel, rows);
    gtk_widget_set_visible(panel->nothing, rows->len == 0);
    panel->last = g_get_monotonic_time();
}

/* Of the group that is closed at first: what is closed is in no window. */
static void focus_row(TinkerPropertyPanel *panel, const char *id)
{
    const Field *field = g_hash_table_lookup(panel->field_of, id);
    const Group *group = g_hash_table_lookup(panel->group_of, tinker_property_group_folded());
    if (field == NULL || group == NULL) return;
    gtk_expander_set_expanded(GTK_EXPANDER(group->expander), TRUE);
    gtk_widget_grab_focus(field->field);
}

static void focus_first(TinkerPropertyPanel *panel)
{
    GtkWidget *expander = gtk_widget_get_first_child(panel->groups);
    GtkWidget *fields = expander != NULL ? gtk_expander_get_child(GTK_EXPANDER(expander)) : NULL;
    if (fields == NULL) return;
    if (gtk_expander_get_expanded(GTK_EXPANDER(expander)))
        gtk_widget_grab_focus(gtk_widget_get_first_child(fields));
    else
        gtk_widget_grab_focus(expander);
}

static gboolean on_refresh(gpointer data)
{
    TinkerPropertyPanel *panel = data;
    panel->refresh = 0;
    refresh(panel);
    if (panel->focus && panel->focused_id != NULL)
        focus_row(panel, panel->focused_id);
    else if (panel->focus)
        focus_first(panel);
    g_clear_pointer(&panel->focused_id, g_free);
    panel->focus = FALSE;
    return G_SOURCE_REMOVE;
}

static void refresh_soon(TinkerPropertyPanel *panel)
{
    if (panel->refresh != 0) return;
    gint64 passed = (g_get_monotonic_time() - panel->last) / 1000;
    panel->refresh = g_timeout_add((guint)CLAMP(REFRESH_INTERVAL - passed, 0, REFRESH_INTERVAL), on_refresh, panel);
}

static void on_replaced(TinkerPropertyPanel *panel)
{
    GHashTableIter iter;
    gpointer value;
    g_hash_table_iter_init(&iter, panel->field_of);
    while (g_hash_table_iter_next(&iter, NULL, &value))
        tinker_property_field_discard(TINKER_PROPERTY_FIELD(((Field *)value)->field));
}

static void tinker_property_panel_map(GtkWidget *widget)
{
    GTK_WIDGET_CLASS(tinker_property_panel_parent_class)->map(widget);
    refresh(TINKER_PROPERTY_PANEL(widget));
}

static void tinker_property_panel_unmap(GtkWidget *widget)
{
    want_modes(TINKER_PROPERTY_PANEL(widget), FALSE);
    GTK_WIDGET_CLASS(tinker_property_panel_parent_class)->unmap(widget);
}

void tinker_property_panel_set_modes(TinkerPropertyPanel *panel, TinkerModesTask *task)
{
    panel->modes = g_object_ref(task);
    g_signal_connect_object(task, "changed", G_CALLBACK(refresh_soon), panel, G_CONNECT_SWAPPED);
}

/* Not at once, since the press that asked for it may still have to be dealt with, and would take the focus back. */
void tinker_property_panel_focus(TinkerPropertyPanel *panel)
{
    panel->focus = TRUE;
    refresh_soon(panel);
}

void tinker_property_panel_focus_law_of_impact(TinkerPropertyPanel *panel)
{
    g_free(panel->focused_id);
    panel->focused_id = tinker_property_law_of_impact_id();
    tinker_property_panel_focus(panel);
}

/* The widget ------------------------------------------------------------------------------------------------------- */

static GtkWidget *make_header(TinkerPropertyPanel *panel)
{
    GtkWidget *header = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6), *title = gtk_label_new(_("Properties"));
    gtk_widget_add_css_class(header, "panel-header");
    gtk_widget_add_css_class(title, "heading");
    gtk_box_append(GTK_BOX(header), title);
    panel->heading = gtk_label_new(NULL);
    gtk_label_set_xalign(GTK_LABEL(panel->heading), 1);
    gtk_label_set_ellipsize(GTK_LABEL(panel->heading), PANGO_ELLIPSIZE_END);
    gtk_widget_set_hexpand(panel->heading, TRUE);
    gtk_widget_add_css_class(panel->heading, "dim-label");
    gtk_box_append(GTK_BOX(header), panel->heading);
    return header;
}

static void make_parts(TinkerPropertyPanel *panel)
{
    GtkWidget *scrolled = gtk_scrolled_window_new(), *content = gtk_box_new(GTK_ORIENTATION_VERTICAL, 0);
    gtk_widget_set_parent(make_header(panel), GTK_WIDGET(panel));
    panel->groups = gtk_box_new(GTK_ORIENTATION_VERTICAL, 2);
    panel->nothing = gtk_label_new(_("Blocks of several types have no properties in common."));
    gtk_label_set_wrap(GTK_LABEL(panel->nothing), TRUE);
    gtk_label_set_xalign(GTK_LABEL(panel->nothing), 0);
    gtk_label_set_max_width_chars(GTK_LABEL(panel->nothing), 1);
    gtk_widget_add_css_class(panel->nothing, "dim-label");
    gtk_widget_set_visible(panel->nothing, FALSE);
    gtk_box_append(GTK_BOX(content), panel->nothing);
    gtk_box_append(GTK_BOX(content), panel->groups);
    gtk_widget_add_css_class(content, "panel-content");
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(scrolled), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), content);
    gtk_widget_set_vexpand(scrolled, TRUE);
    gtk_widget_set_parent(scrolled, GTK_WIDGET(panel));
}

GtkWidget *tinker_property_panel_new(TinkerDocument *document, TinkerPlayer *player)
{
    TinkerPropertyPanel *panel = g_object_new(TINKER_TYPE_PROPERTY_PANEL, NULL);
    panel->document = g_object_ref(document);
    panel->player = g_object_ref(player);
    g_signal_connect_object(document, "changed", G_CALLBACK(refresh_soon), panel, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "replaced", G_CALLBACK(on_replaced), panel, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "selection-changed", G_CALLBACK(refresh_soon), panel, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "moved", G_CALLBACK(refresh_soon), panel, G_CONNECT_SWAPPED);
    return GTK_WIDGET(panel);
}

static void tinker_property_panel_get_property(GObject *object, guint id, GValue *value, GParamSpec *spec)
{
    g_value_set_boolean(value, TINKER_PROPERTY_PANEL(object)->trims);
}

static void tinker_property_panel_set_property(GObject *object, guint id, const GValue *value, GParamSpec *spec)
{
    TinkerPropertyPanel *panel = TINKER_PROPERTY_PANEL(object);
    if (panel->trims == g_value_get_boolean(value)) return;
    panel->trims = !panel->trims;
    refresh_soon(panel);
    g_object_notify_by_pspec(object, spec);
}

static void tinker_property_panel_dispose(GObject *object)
{
    TinkerPropertyPanel *panel = TINKER_PROPERTY_PANEL(object);
    if (panel->refresh != 0) g_source_remove(panel->refresh);
    panel->refresh = 0;
    tinker_unparent_children(GTK_WIDGET(object));
    g_clear_object(&panel->document);
    g_clear_object(&panel->player);
    g_clear_object(&panel->modes);
    g_clear_pointer(&panel->focused_id, g_free);
    g_clear_pointer(&panel->group_of, g_hash_table_unref);
    g_clear_pointer(&panel->field_of, g_hash_table_unref);
    g_clear_pointer(&panel->closed, g_hash_table_unref);
    G_OBJECT_CLASS(tinker_property_panel_parent_class)->dispose(object);
}

static void tinker_property_panel_class_init(TinkerPropertyPanelClass *class)
{
    GObjectClass *object_class = G_OBJECT_CLASS(class);
    object_class->get_property = tinker_property_panel_get_property;
    object_class->set_property = tinker_property_panel_set_property;
    object_class->dispose = tinker_property_panel_dispose;
    const GParamFlags flags = G_PARAM_READWRITE | G_PARAM_STATIC_STRINGS | G_PARAM_EXPLICIT_NOTIFY;
    g_object_class_install_property(object_class, PROP_TRIMS, g_param_spec_boolean("trims", NULL, NULL, FALSE, flags));
    GTK_WIDGET_CLASS(class)->map = tinker_property_panel_map;
    GTK_WIDGET_CLASS(class)->unmap = tinker_property_panel_unmap;
    gtk_widget_class_set_layout_manager_type(GTK_WIDGET_CLASS(class), GTK_TYPE_BOX_LAYOUT);
    gtk_widget_class_set_css_name(GTK_WIDGET_CLASS(class), "propertypanel");
}

static void tinker_property_panel_init(TinkerPropertyPanel *panel)
{
    GtkLayoutManager *layout = gtk_widget_get_layout_manager(GTK_WIDGET(panel));
    gtk_orientable_set_orientation(GTK_ORIENTABLE(layout), GTK_ORIENTATION_VERTICAL);
    panel->group_of = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free);
    panel->field_of = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free);
    panel->closed = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    g_hash_table_add(panel->closed, g_strdup(tinker_property_group_folded()));
    make_parts(panel);
}
