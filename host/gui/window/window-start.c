/* How things start, and what is wrong with it: the section of the panel, notices, marks on the canvas and the menu. */
#include "gui/accuracy/advice-list.h"
#include "gui/start/left-behind.h"
#include "gui/start/start-offer.h"
#include "gui/start/start-panel.h"
#include "gui/text/sentence.h"
#include "gui/window/window-parts.h"

#include <glib/gi18n.h>

/* What a notice of a finding needs; the bar forgets it when the list changes. */
typedef struct {
    TinkerWindow *window;
    TinkerAdviceList *list;
    guint finding;
} Finding;

/* Advice
 * ---------------------------------------------------------------------------------------------------------------- */

static void repair(void *data)
{
    const Finding *finding = data;
    g_autoptr(GError) error = NULL;
    if (!tinker_advice_list_repair(finding->list, finding->finding, &error))
        window_toast(finding->window, error->message);
}

static void append_blocks(GArray *blocks, TinkerWindow *window, const TinkerAdvice *advice)
{
    TinkerScene *scene = tinker_document_scene(window->document);
    for (guint i = 0; i < advice->blocks->len; i++) {
        TinkerBlockId block = g_array_index(advice->blocks, TinkerBlockId, i);
        if (tinker_scene_has_block(scene, block)) g_array_append_val(blocks, block);
    }
}

static void select_blocks(void *data)
{
    const Finding *finding = data;
    g_autoptr(GArray) blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    append_blocks(blocks, finding->window,
                  g_ptr_array_index(tinker_advice_list_findings(finding->list), finding->finding));
    tinker_document_select_all_of(finding->window->document, (const TinkerBlockId *)(gpointer)blocks->data,
                                  (int)blocks->len);
}

/* An end that is loose is an error only for who has finished building. */
static TinkerNoticeSeverity severity_of(const TinkerAdvice *advice)
{
    gboolean is_error = advice->blocks_run && advice->kind != TINKER_ADVICE_DETACHED_END;
    return is_error ? TINKER_NOTICE_ERROR : TINKER_NOTICE_WARNING;
}

static TinkerNotice *notice_of(TinkerWindow *window, TinkerAdviceList *list, guint number)
{
    const TinkerAdvice *advice = g_ptr_array_index(tinker_advice_list_findings(list), number);
    Finding *finding = g_new(Finding, 1);
    *finding = (Finding){window, list, number};
    g_autofree char *text = tinker_sentence_in(tinker_document_scene(window->document), advice->message);
    TinkerNotice *notice = tinker_notice_new(severity_of(advice), text, advice->repair, repair, finding, g_free);
    notice->locate = select_blocks;
    return notice;
}

/* Tells the findings, and marks their blocks. */
static void on_advice_changed(TinkerAdviceList *list, TinkerWindow *window)
{
    const GPtrArray *findings = tinker_advice_list_findings(list);
    GPtrArray *notices = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_notice_free);
    g_autoptr(GArray) blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (guint i = 0; i < findings->len; i++) {
        append_blocks(blocks, window, g_ptr_array_index(findings, i));
        g_ptr_array_add(notices, notice_of(window, list, i));
    }
    tinker_notice_bar_set(window->notices, "start", notices);
    tinker_canvas_set_marked(window->canvas, (const TinkerBlockId *)(gpointer)blocks->data, (int)blocks->len);
}

/* Left behind
 * ---------------------------------------------------------------------------------------------------------- */

typedef struct {
    TinkerWindow *window;
    TinkerLying lying;
} Left;

static void lay(void *data)
{
    const Left *left = data;
    TinkerWindow *window = left->window;
    g_autoptr(GError) error = NULL;
    if (!tinker_left_behind_lay(window->document, &left->lying, &error)) window_toast(window, error->message);
}

static void select_left(void *data)
{
    const Left *left = data;
    tinker_document_select(left->window->document, left->lying.body);
}

static void on_left_changed(TinkerLeftBehind *behind, TinkerWindow *window)
{
    const GArray *bodies = tinker_left_behind_bodies(behind);
    TinkerScene *scene = tinker_document_scene(window->document);
    GPtrArray *notices = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_notice_free);
    for (guint i = 0; i < bodies->len; i++) {
        Left *left = g_new(Left, 1);
        *left = (Left){window, g_array_index(bodies, TinkerLying, i)};
        const char *plate = tinker_scene_block_name(scene, left->lying.plate);
        g_autofree char *text = g_strdup_printf(_("%s stayed where it was, and does not lie on %s any more."),
                                                tinker_scene_block_name(scene, left->lying.body), plate);
        g_autofree char *button = g_strdup_printf(_("Place on %s"), plate);
        TinkerNotice *notice = tinker_notice_new(TINKER_NOTICE_WARNING, text, button, lay, left, g_free);
        notice->locate = select_left;
        g_ptr_array_add(notices, notice);
    }
    tinker_notice_bar_set(window->notices, "left behind", notices);
}

/* Start conditions
 * ------------------------------------------------------------------------------------------------------ */

static void on_refused(TinkerWindow *window, const char *message)
{
    window_toast(window, message);
}

static void on_start(GSimpleAction *action, GVariant *parameter, gpointer data)
{
    TinkerWindow *window = data;
    gint32 kind, other;
    g_autoptr(GError) error = NULL;
    g_variant_get(parameter, "(ii)", &kind, &other);
    g_autoptr(GPtrArray) options =
        tinker_start_options_new(tinker_document_scene(window->document), tinker_document_selected(window->document));
    const TinkerStartOption *option = tinker_start_find(options, (TinkerStartKind)kind, other);
    if (option == NULL || option->asks) return;
    if (!tinker_start_do(window->document, window->player, option, 0, &error)) window_toast(window, error->message);
}

/* Public
 * ---------------------------------------------------------------------------------------------------------------- */

void window_add_start_menu(TinkerWindow *window, GMenu *menu)
{
    g_autoptr(GMenuModel) start = tinker_start_menu_new(window->document);
    if (start == NULL) return;
    g_autoptr(GMenu) section = g_menu_new();
    g_menu_append_submenu(section, _("_Start"), start);
    g_menu_append_section(menu, NULL, G_MENU_MODEL(section));
}

GtkWidget *window_new_start_panel(TinkerWindow *window)
{
    GtkWidget *panel = tinker_start_panel_new(window->document, window->player);
    g_signal_connect_object(panel, "refused", G_CALLBACK(on_refused), window, G_CONNECT_SWAPPED);
    return panel;
}

void window_add_start(TinkerWindow *window)
{
    const GActionEntry entry = {.name = "start", .activate = on_start, .parameter_type = "(ii)"};
    g_action_map_add_action_entries(G_ACTION_MAP(window), &entry, 1, window);
    TinkerAdviceList *list = tinker_advice_list_new(window->document, window->player);
    g_signal_connect_object(list, "changed", G_CALLBACK(on_advice_changed), window, 0);
    g_object_set_data_full(G_OBJECT(window->notices), "advice", list, g_object_unref);
    TinkerLeftBehind *behind = tinker_left_behind_new(window->document);
    g_signal_connect_object(behind, "changed", G_CALLBACK(on_left_changed), window, 0);
    g_object_set_data_full(G_OBJECT(window->notices), "left-behind", behind, g_object_unref);
}
