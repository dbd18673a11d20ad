/* All of the page is of one moment, that of the task's result, which stands at the top: only books that take long stay
 * where they were while it plays, and tell their own. Of what is not seen values wait until it is, or until it stops.
 */
#include "gui/equation/equations-page.h"

#include <glib/gi18n.h>
#include <string.h>

#include "equations/write/lines.h"
#include "gui/equation/equation-fill.h"
#include "gui/equation/equation-list.h"
#include "gui/equation/model-picture.h"
#include "gui/text/sentence.h"
#include "gui/widget/unparent.h"

#define MOST_BODIES 30 /* whose equations are shown where none are selected */

#define VALUES_TIP                                                                                                     \
    N_("The force of each term now, beneath it: of terms over one bracket, or of all of a block that stand apart "     \
       "(Σ), their sum")

enum { NEWTON, MATRIX, ANGLES };

struct _TinkerEquationsPage {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    TinkerModelTask *task;
    TinkerEquationFill *fill;
    GtkWidget *rows, *rest; /* what bodies do, and what the symbols stand for */
    char *written;          /* the equations in the rows, as one text; NULL: there are none */
    gboolean is_behind;     /* what is not seen is of an earlier result, and what is read out */
    gboolean is_chosen;     /* the form, in this scene */
    gboolean is_leaving;    /* the form, which has no equations */
    char *why_newton;       /* in place of another form; NULL: they were asked for */
    GtkWidget *forms, *values, *moment, *notice, *hint, *diagram_heading, *diagram, *books_heading, *books;
};

G_DEFINE_FINAL_TYPE(TinkerEquationsPage, tinker_equations_page, GTK_TYPE_WIDGET)

/* Equations -------------------------------------------------------------------------------------------------------- */

static guint form_of(TinkerEquationsPage *page)
{
    return gtk_drop_down_get_selected(GTK_DROP_DOWN(page->forms));
}

static gboolean is_playing(TinkerEquationsPage *page)
{
    return tinker_player_state(page->player) == TINKER_PLAYER_PLAYING;
}

static gboolean shows_values(TinkerEquationsPage *page)
{
    return gtk_check_button_get_active(GTK_CHECK_BUTTON(page->values));
}

/* What is selected, else the first of all. (transfer full) */
static TinkerBlockId *shown_bodies(const TinkerModelResult *result)
{
    const GPtrArray *all = result->equations->bodies;
    guint count = 0;
    while (result->bodies[count] != TINKER_NO_BLOCK)
        count++;
    const gboolean some = count > 0;
    if (!some) count = MIN(all->len, MOST_BODIES);
    TinkerBlockId *bodies = g_new(TinkerBlockId, count + 1);
    for (guint i = 0; i < count; i++)
        bodies[i] = some ? result->bodies[i] : ((const TinkerBodyEquation *)g_ptr_array_index(all, i))->block;
    bodies[count] = TINKER_NO_BLOCK;
    return bodies;
}

/* (transfer full) */
static GPtrArray *lines_of(TinkerEquationsPage *page, const TinkerModelResult *result, TinkerTypesetFormat format)
{
    g_autofree TinkerBlockId *bodies = shown_bodies(result);
    const TinkerEquationsShown shown = {format, "", bodies, FALSE};
    const guint form = form_of(page);
    return tinker_equations_lines(result->equations, form == MATRIX ? result->matrix : NULL,
                                  form == ANGLES ? result->angles : NULL, &shown);
}

static void on_task_changed(TinkerEquationsPage *page);

static void update_values(TinkerEquationsPage *page)
{
    const TinkerModelResult *result = tinker_model_task_result(page->task);
    const gboolean shown = shows_values(page) && result != NULL && result->equations != NULL;
    const TinkerUnitSystem units = tinker_scene_head(tinker_document_scene(page->document))->units;
    const gboolean tell = !is_playing(page); /* else it would never end */
    const guint form = form_of(page);
    g_autoptr(GPtrArray) lines = shown && form == MATRIX ? lines_of(page, result, TINKER_TYPESET_MATHML) : NULL;
    tinker_equation_list_show_values(page->rows, shown && form == NEWTON ? result->state : NULL, units, tell);
    tinker_equation_list_show_line_values(page->rows, lines, units, tell);
}

/* Above the rows: why there are no others, or none. NULL: nothing is to be said. */
static void show_notice(TinkerEquationsPage *page, const char *text)
{
    gtk_label_set_text(GTK_LABEL(page->notice), text != NULL ? text : "");
    gtk_widget_set_visible(page->notice, text != NULL);
}

static void clear_rows(TinkerEquationsPage *page)
{
    tinker_equation_fill_stop(page->fill);
    tinker_unparent_children(page->rows);
    tinker_unparent_children(page->rest);
    g_clear_pointer(&page->written, g_free);
}

/* Of Newton's equations those of bodies: below them stands what the symbols in them are. */
static guint count_rows(TinkerEquationsPage *page, const GPtrArray *lines)
{
    for (guint i = 0; form_of(page) == NEWTON && i + 1 < lines->len; i++) {
        const TinkerEquationLine *line = g_ptr_array_index(lines, i), *next = g_ptr_array_index(lines, i + 1);
        if (line->heading != NULL && next->component < 0) return i;
    }
    return lines->len;
}

static void on_filled(gpointer data)
{
    TinkerEquationsPage *page = data;
    if (page->is_behind && !is_playing(page))
        on_task_changed(page);
    else
        update_values(page);
}

/* Rows are made anew where the equations have become others, and what stands below them; while it plays values alone
 * become others. */
static void show_rows(TinkerEquationsPage *page, const TinkerModelResult *result)
{
    g_autoptr(GPtrArray) shown = lines_of(page, result, TINKER_TYPESET_MATHML);
    g_autofree char *written = tinker_equation_lines_written(shown, result->scene);
    const gboolean same = page->why_newton == NULL && g_strcmp0(written, page->written) == 0;
    const gboolean fills = tinker_equation_fill_is_going(page->fill);
    page->is_behind = same && (is_playing(page) || fills);
    if (same && fills) return; /* else none that plays would ever be full */
    guint row_count = count_rows(page, shown);
    if (page->is_behind) {
        tinker_equation_list_update(page->rows, shown, 0, row_count);
        tinker_equation_list_update(page->rest, shown, row_count, shown->len);
        return;
    }
    g_autoptr(GPtrArray) spoken = lines_of(page, result, TINKER_TYPESET_SPEECH);
    /* Elsewhere numbers stand among the equations. */
    if (same && form_of(page) == NEWTON) {
        g_ptr_array_remove_range(shown, 0, row_count);
        g_ptr_array_remove_range(spoken, 0, row_count);
        row_count = 0;
        tinker_unparent_children(page->rest);
    } else {
        clear_rows(page);
        page->written = g_steal_pointer(&written);
        show_notice(page, page->why_newton != NULL ? page->why_newton
                          : shown->len == 0        ? _("Nothing in this scene can move.")
                                                   : NULL);
        g_clear_pointer(&page->why_newton, g_free);
    }
    tinker_equation_fill_start(page->fill, page->rows, page->rest, row_count, g_steal_pointer(&shown),
                               g_steal_pointer(&spoken));
}

/* Whether the form that is chosen has an equation. */
static gboolean has_chosen_form(TinkerEquationsPage *page, const TinkerModelResult *result)
{
    const guint form = form_of(page);
    if (form == MATRIX) return result->matrix != NULL && result->matrix->islands->len + result->matrix->large->len > 0;
    return form != ANGLES || result->angles->trees->len > 0;
}

/* Newton's equations are always there: back to them, with the reason why those that were chosen in this scene are not.
 * FALSE where that is not needed; else all is shown by now. */
static gboolean leave_form_without_equations(TinkerEquationsPage *page, const TinkerModelResult *result)
{
    if (result == NULL || result->equations == NULL || has_chosen_form(page, result)) return FALSE;
    const gboolean matrix = form_of(page) == MATRIX;
    g_autoptr(GPtrArray) reasons =
        matrix && result->matrix == NULL ? g_ptr_array_new() : lines_of(page, result, TINKER_TYPESET_TEXT);
    const TinkerEquationLine *first = reasons->len > 0 ? g_ptr_array_index(reasons, 0) : NULL;
    g_free(page->why_newton);
    page->why_newton = !page->is_chosen ? NULL
                                        : g_strdup_printf(_("%s. These are Newton's."),
                                                          first != NULL && first->heading != NULL ? first->heading
                                                          : matrix ? _("There are no equations in matrices")
                                                                   : _("There are no equations in angles"));
    page->is_leaving = TRUE;
    gtk_drop_down_set_selected(GTK_DROP_DOWN(page->forms), NEWTON);
    page->is_leaving = FALSE;
    return TRUE;
}

static void show_moment(TinkerEquationsPage *page, const TinkerModelResult *result)
{
    static const TinkerDimension seconds = TINKER_DIMENSION_TIME;
    const TinkerUnitSystem units = tinker_scene_head(result->scene)->units;
    g_autofree char *time = tinker_quantity_brief(result->time, seconds, units);
    g_autofree char *text = g_strconcat("t = ", time, NULL);
    gtk_label_set_text(GTK_LABEL(page->moment), text);
}

static void show_pictures(TinkerEquationsPage *page, const TinkerModelResult *result)
{
    const gboolean has_body = result != NULL && result->equations != NULL && result->bodies[0] != TINKER_NO_BLOCK;
    gtk_widget_set_visible(page->hint, result != NULL && result->equations != NULL && !has_body &&
                                           result->equations->bodies->len > 0);
    gtk_widget_set_visible(page->diagram, has_body);
    gtk_widget_set_visible(page->diagram_heading, has_body);
    gtk_widget_set_visible(page->books, has_body && result->books != NULL);
    gtk_widget_set_visible(page->books_heading, has_body && result->books != NULL);
    g_autofree char *since = has_body && result->start > 0
                                 ? g_strdup_printf(_("Books since the change at %.4g s"), result->start)
                                 : g_strdup(_("Books"));
    gtk_label_set_text(GTK_LABEL(page->books_heading), since);
    gtk_widget_queue_draw(page->diagram);
    gtk_widget_queue_draw(page->books);
}

static void on_task_changed(TinkerEquationsPage *page)
{
    const TinkerModelResult *result = tinker_model_task_result(page->task);
    if (leave_form_without_equations(page, result)) return;
    if (result != NULL && result->equations != NULL) {
        show_rows(page, result);
        show_moment(page, result);
        update_values(page);
    } else {
        clear_rows(page);
        show_notice(page, NULL);
        gtk_label_set_text(GTK_LABEL(page->moment), "");
    }
    if (result != NULL && result->equations == NULL && result->error != NULL) {
        g_autofree char *text = tinker_sentence_in(tinker_document_scene(page->document), result->error->message);
        show_notice(page, text);
    }
    show_pictures(page, result);
}

static void on_form_chosen(TinkerEquationsPage *page)
{
    const gboolean has_values = form_of(page) != ANGLES;
    page->is_chosen = !page->is_leaving;
    gtk_widget_set_sensitive(page->values, has_values);
    gtk_widget_set_tooltip_text(page->values,
                                has_values ? _(VALUES_TIP)
                                           : _("Terms in angles are not told one by one; the values of their symbols "
                                               "stand below"));
    on_task_changed(page);
}

/* The form stays where the next scene has it. */
static void on_replaced(TinkerEquationsPage *page)
{
    page->is_chosen = FALSE;
}

/* Copying ---------------------------------------------------------------------------------------------------------- */

static void copy_equations(GtkWidget *widget, const char *name, GVariant *parameter)
{
    static const char *const names[] = {"text", "latex", "mathml", NULL};
    TinkerEquationsPage *page = TINKER_EQUATIONS_PAGE(widget);
    const TinkerModelResult *result = tinker_model_task_result(page->task);
    int format = 0;
    while (names[format] != NULL && !g_str_equal(names[format], g_variant_get_string(parameter, NULL)))
        format++;
    if (result == NULL || result->equations == NULL || names[format] == NULL) return;
    g_autofree TinkerBlockId *bodies = shown_bodies(result);
    g_autofree char *title = tinker_document_name(page->document);
    const TinkerEquationsShown shown = {(TinkerTypesetFormat)format, title, bodies, FALSE};
    g_autofree char *text = tinker_equations_write(result->equations, form_of(page) == MATRIX ? result->matrix : NULL,
                                                   form_of(page) == ANGLES ? result->angles : NULL, &shown);
    gdk_clipboard_set_text(gtk_widget_get_clipboard(widget), text);
}

/* What is going on ------------------------------------------------------------------------------------------------- */

/* Where it stops at the moment of the last result, no other one comes. */
static void on_state_changed(TinkerEquationsPage *page)
{
    if (!is_playing(page) && page->is_behind) on_task_changed(page);
}

static void tinker_equations_page_map(GtkWidget *widget)
{
    GTK_WIDGET_CLASS(tinker_equations_page_parent_class)->map(widget);
    tinker_model_task_want(TINKER_EQUATIONS_PAGE(widget)->task, TRUE);
}

static void tinker_equations_page_unmap(GtkWidget *widget)
{
    tinker_model_task_want(TINKER_EQUATIONS_PAGE(widget)->task, FALSE);
    GTK_WIDGET_CLASS(tinker_equations_page_parent_class)->unmap(widget);
}

gboolean tinker_equations_page_is_behind(TinkerEquationsPage *page)
{
    return tinker_model_task_is_due(page->task) || tinker_equation_fill_is_going(page->fill);
}

/* Life ------------------------------------------------------------------------------------------------------------- */

static GtkWidget *new_copy_button(void)
{
    GtkWidget *button = gtk_menu_button_new();
    g_autoptr(GMenu) menu = g_menu_new();
    g_menu_append(menu, _("Copy as Text"), "equations.copy::text");
    g_menu_append(menu, _("Copy as LaTeX"), "equations.copy::latex");
    g_menu_append(menu, _("Copy as MathML"), "equations.copy::mathml");
    gtk_menu_button_set_icon_name(GTK_MENU_BUTTON(button), "edit-copy-symbolic");
    gtk_menu_button_set_menu_model(GTK_MENU_BUTTON(button), G_MENU_MODEL(menu));
    gtk_widget_set_tooltip_text(button, _("Copy the Equations"));
    gtk_accessible_update_property(GTK_ACCESSIBLE(button), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Copy the Equations"), -1);
    return button;
}

static void add_tools(TinkerEquationsPage *page)
{
    const char *const forms[] = {_("Newton"), _("Matrix"), _("Angles"), NULL};
    GtkWidget *tools = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 8), *copy = new_copy_button();
    page->forms = gtk_drop_down_new_from_strings(forms);
    page->values = gtk_check_button_new_with_label(_("Values"));
    gtk_accessible_update_property(GTK_ACCESSIBLE(page->forms), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Form of Equations"),
                                   -1);
    gtk_widget_set_tooltip_text(page->values, _(VALUES_TIP));
    page->moment = tinker_equation_label(NULL, "dim-label");
    gtk_widget_set_hexpand(page->moment, TRUE);
    gtk_widget_set_tooltip_text(page->moment, _("The moment that this page is of"));
    gtk_box_append(GTK_BOX(tools), page->forms);
    gtk_box_append(GTK_BOX(tools), page->values);
    gtk_box_append(GTK_BOX(tools), page->moment);
    gtk_box_append(GTK_BOX(tools), copy);
    gtk_widget_set_parent(tools, GTK_WIDGET(page));
    g_signal_connect_swapped(page->forms, "notify::selected", G_CALLBACK(on_form_chosen), page);
    g_signal_connect_swapped(page->values, "toggled", G_CALLBACK(update_values), page);
}

static GtkWidget *add_heading(TinkerEquationsPage *page, const char *text)
{
    GtkWidget *label = gtk_label_new(text);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_widget_add_css_class(label, "heading");
    gtk_widget_set_visible(label, FALSE);
    gtk_widget_set_parent(label, GTK_WIDGET(page));
    return label;
}

static void add_results(TinkerEquationsPage *page)
{
    page->hint =
        tinker_equation_label(_("Select bodies to see theirs alone, with a free-body diagram and books."), "dim-label");
    gtk_widget_set_visible(page->hint, FALSE);
    gtk_widget_set_parent(page->hint, GTK_WIDGET(page));
    page->diagram_heading = add_heading(page, _("Diagram"));
    page->diagram = tinker_model_diagram_new(page->document, page->task);
    gtk_widget_set_parent(page->diagram, GTK_WIDGET(page));
    page->rest = gtk_box_new(GTK_ORIENTATION_VERTICAL, 4);
    gtk_widget_set_parent(page->rest, GTK_WIDGET(page));
    page->books_heading = add_heading(page, _("Books"));
    page->books = tinker_model_books_new(page->document, page->task);
    gtk_widget_set_parent(page->books, GTK_WIDGET(page));
}

GtkWidget *tinker_equations_page_new(TinkerDocument *document, TinkerPlayer *player)
{
    TinkerEquationsPage *page = g_object_new(TINKER_TYPE_EQUATIONS_PAGE, NULL);
    page->document = g_object_ref(document);
    page->player = g_object_ref(player);
    page->task = tinker_model_task_new(document, player);
    page->fill = tinker_equation_fill_new(document, on_filled, page);
    add_results(page);
    g_signal_connect_object(page->task, "changed", G_CALLBACK(on_task_changed), page, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "replaced", G_CALLBACK(on_replaced), page, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(on_state_changed), page, G_CONNECT_SWAPPED);
    return GTK_WIDGET(page);
}

static void tinker_equations_page_dispose(GObject *object)
{
    TinkerEquationsPage *page = TINKER_EQUATIONS_PAGE(object);
    g_clear_pointer(&page->fill, tinker_equation_fill_free); /* which adds to the rows */
    if (page->rows != NULL) tinker_unparent_children(GTK_WIDGET(object));
    page->rows = NULL;
    g_clear_pointer(&page->why_newton, g_free);
    g_clear_pointer(&page->written, g_free);
    g_clear_object(&page->task);
    g_clear_object(&page->player);
    g_clear_object(&page->document);
    G_OBJECT_CLASS(tinker_equations_page_parent_class)->dispose(object);
}

static void tinker_equations_page_class_init(TinkerEquationsPageClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = tinker_equations_page_dispose;
    widget_class->map = tinker_equations_page_map;
    widget_class->unmap = tinker_equations_page_unmap;
    gtk_widget_class_install_action(widget_class, "equations.copy", "s", copy_equations);
    gtk_widget_class_set_layout_manager_type(widget_class, GTK_TYPE_BOX_LAYOUT);
    gtk_widget_class_set_css_name(widget_class, "equationspage");
    gtk_widget_class_set_accessible_role(widget_class, GTK_ACCESSIBLE_ROLE_GROUP);
}

static void tinker_equations_page_init(TinkerEquationsPage *page)
{
    GtkLayoutManager *layout = gtk_widget_get_layout_manager(GTK_WIDGET(page));
    gtk_orientable_set_orientation(GTK_ORIENTABLE(layout), GTK_ORIENTATION_VERTICAL);
    gtk_box_layout_set_spacing(GTK_BOX_LAYOUT(layout), 8);
    add_tools(page);
    page->notice = tinker_equation_label(NULL, "dim-label");
    gtk_widget_set_visible(page->notice, FALSE);
    gtk_widget_set_parent(page->notice, GTK_WIDGET(page));
    page->rows = gtk_box_new(GTK_ORIENTATION_VERTICAL, 4);
    gtk_widget_set_parent(page->rows, GTK_WIDGET(page));
    gtk_accessible_update_property(GTK_ACCESSIBLE(page), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Equations"), -1);
}
