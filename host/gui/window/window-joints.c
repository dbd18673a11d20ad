/* Bodies that are dropped onto each other: a joint is offered where they meet. */
#include "edit/drag.h"
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
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = g_ptr_array_index(libraries, i);
        if (library->refused != NULL || library->shadowed_by != NULL) continue;
        for (guint k = 0; k < library->types->len; k++) {
            const TinkerTypeEntry *entry = g_ptr_array_index(library->types, k);
            const TinkerBlockClass *joint = tinker_catalogue_type(catalogue, entry->id, NULL);
            const TinkerConstraint *constraint =
                joint != NULL && joint->physics != NULL ? joint->physics->constraint : NULL;
            if (constraint != NULL && constraint->joint != 0 && constraint->rows == 2) return joint;
        }
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
