/* Bodies that are dropped onto each other: a joint is offered where they meet; one that is dropped onto a top and would
 * fall through it can be made solid. Corners of outlines in the menu of the selection: one more where the pointer is,
 * and the one that it is on away. */
#include "edit/drag.h"
#include "edit/outline.h"
#include "gui/text/translate.h"
#include "gui/window/window-parts.h"

#include <glib/gi18n.h>

/* A body that was dropped, the one that it met, and what would join them. */
typedef struct {
    TinkerWindow *window;
    TinkerBlockId dropped, met;
    const TinkerBlockClass *joint;
} Meeting;

/* The first joint of the catalogue that lets bodies turn: its rows hold two places together and no more. NULL: there is
 * none. */
static const TinkerBlockClass *turning_joint(TinkerCatalogue *catalogue)
{
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue), types = tinker_libraries_types(libraries);
    for (guint i = 0; i < types->len; i++) {
        const TinkerTypeEntry *entry = g_ptr_array_index(types, i);
        const TinkerBlockClass *joint = tinker_catalogue_type(catalogue, entry->id, NULL);
        const TinkerConstraint *constraint =
            joint != NULL && joint->physics != NULL ? joint->physics->constraint : NULL;
        if (constraint != NULL && constraint->joint != 0 && constraint->rows == 2) return joint;
    }
    return NULL;
}

static void join(void *data)
{
    const Meeting *meeting = data;
    TinkerWindow *window = meeting->window;
    const TinkerBlockClass *joint = meeting->joint;
    const TinkerBlockId blocks[] = {meeting->met, meeting->dropped};
    tinker_document_select_all_of(window->document, blocks, G_N_ELEMENTS(blocks));
    tinker_canvas_add(window->canvas, joint); /* the notice goes with this change, and the meeting with it */
}

static void select_both(void *data)
{
    const Meeting *meeting = data;
    const TinkerBlockId blocks[] = {meeting->met, meeting->dropped};
    tinker_document_select_all_of(meeting->window->document, blocks, G_N_ELEMENTS(blocks));
}

/* NULL: nothing meets. */
static void tell(TinkerWindow *window, const Meeting *meeting)
{
    GPtrArray *notices = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_notice_free);
    if (meeting != NULL) {
        TinkerScene *scene = tinker_document_scene(window->document);
        g_autofree char *text =
            g_strdup_printf(_("%s and %s meet there."), tinker_scene_block_name(scene, meeting->dropped),
                            tinker_scene_block_name(scene, meeting->met));
        g_autofree char *button = g_strdup_printf(_("Add %s"), tinker_translate(meeting->joint->type->title));
        TinkerNotice *notice =
            tinker_notice_new(TINKER_NOTICE_HINT, text, button, join, g_memdup2(meeting, sizeof *meeting), g_free);
        notice->locate = select_both;
        g_ptr_array_add(notices, notice);
    }
    tinker_notice_bar_set(window->notices, "meeting", notices);
}

static void on_dropped(TinkerCanvas *canvas, TinkerBlockId block, double reach, TinkerWindow *window)
{
    TinkerScene *scene = tinker_document_scene(window->document);
    const TinkerBlockClass *joint = turning_joint(tinker_document_catalogue(window->document));
    const TinkerBlockId met = joint != NULL ? tinker_body_met(scene, block, reach) : TINKER_NO_BLOCK;
    if (met != TINKER_NO_BLOCK) tell(window, &(Meeting){window, block, met, joint});
}

/* What is edited afterwards makes the offer void: where they still meet, another drop finds them. */
static void on_changed(TinkerWindow *window)
{
    if (!tinker_history_is_open(tinker_document_history(window->document))) tell(window, NULL);
}

void window_add_joints(TinkerWindow *window)
{
    g_signal_connect_object(window->canvas, "dropped", G_CALLBACK(on_dropped), window, 0);
    g_signal_connect_object(window->document, "changed", G_CALLBACK(on_changed), window, G_CONNECT_SWAPPED);
}

/* Corners --------------------------------------------------------------------------------------------------------- */

static void add_corner(GSimpleAction *action, GVariant *at, gpointer data)
{
    TinkerWindow *window = data;
    const TinkerBlockId block = tinker_document_selected(window->document);
    double place[2];
    g_variant_get(at, "(dd)", &place[0], &place[1]);
    if (block == TINKER_NO_BLOCK) return;
    tinker_document_begin(window->document, "Add corner", NULL);
    tinker_outline_add(tinker_document_history(window->document), tinker_document_scene(window->document), block,
                       place);
    tinker_document_end(window->document);
}

static void remove_corner(GSimpleAction *action, GVariant *number, gpointer data)
{
    TinkerWindow *window = data;
    const TinkerBlockId block = tinker_document_selected(window->document);
    if (block == TINKER_NO_BLOCK) return;
    tinker_document_begin(window->document, "Remove corner", NULL);
    tinker_outline_remove(tinker_document_history(window->document), tinker_document_scene(window->document), block,
                          g_variant_get_int32(number));
    tinker_document_end(window->document);
}

static void append(GMenu *section, const char *label, const char *action, GVariant *target, gboolean can)
{
    g_autoptr(GMenuItem) item = g_menu_item_new(label, NULL);
    g_menu_item_set_action_and_target_value(item, can ? action : "win.none", target);
    g_menu_append_item(section, item);
}

void window_append_outline_menu(TinkerWindow *window, GMenu *menu)
{
    TinkerScene *scene = tinker_document_scene(window->document);
    const TinkerBlockId block = tinker_document_selected(window->document);
    int selected;
    tinker_document_selection(window->document, &selected);
    if (selected != 1 || !tinker_outline_is_of(tinker_scene_block_class(scene, block)) ||
        tinker_player_time(window->player) > 0)
        return;
    double place[2];
    const TinkerHit hit = tinker_canvas_handle(window->canvas, place);
    g_autoptr(GMenu) section = g_menu_new();
    if (hit.part >= TINKER_PART_POINT)
        append(section, _("Remove Corner"), "win.remove-corner", g_variant_new_int32(hit.part - TINKER_PART_POINT),
               tinker_outline_corners(scene, block) > TINKER_LEAST_CORNERS);
    else
        append(section, _("Add Corner Here"), "win.add-corner", g_variant_new("(dd)", place[0], place[1]), TRUE);
    g_menu_append_section(menu, NULL, G_MENU_MODEL(section));
}

void window_add_outline_actions(TinkerWindow *window)
{
    static const GActionEntry actions[] = {
        {.name = "add-corner", .activate = add_corner, .parameter_type = "(dd)"},
        {.name = "remove-corner", .activate = remove_corner, .parameter_type = "i"},
    };
    g_action_map_add_action_entries(G_ACTION_MAP(window), actions, G_N_ELEMENTS(actions), window);
}
