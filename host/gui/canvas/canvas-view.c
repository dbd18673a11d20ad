/* The part of the world that a canvas shows. */
#include <glib/gi18n.h>

#include "gui/canvas/canvas-private.h"
#include "gui/text/block-words.h"
#include "render/draw/text.h"

#define LEAST_SCALE    1e-6 /* widget units per m */
#define GREATEST_SCALE 1e9

const TinkerView *tinker_canvas_view(TinkerCanvas *canvas)
{
    return &canvas->view;
}

double canvas_reach(TinkerCanvas *canvas)
{
    return CANVAS_REACH / canvas->view.scale;
}

double canvas_top_reach(TinkerCanvas *canvas)
{
    return CANVAS_TOP / canvas->view.scale;
}

double canvas_grid(TinkerCanvas *canvas, GdkModifierType modifiers)
{
    const TinkerSceneHead *head = tinker_scene_head(tinker_document_scene(canvas->document));
    return head->canvas_snap && !(modifiers & GDK_ALT_MASK) ? head->canvas_grid : 0;
}

void canvas_to_world(TinkerCanvas *canvas, double x, double y, double world[2])
{
    tinker_view_to_world(&canvas->view, x, y, &world[0], &world[1]);
}

/* What is selected, in words, as it starts. (transfer full) */
static char *selection_words(TinkerCanvas *canvas)
{
    int count = 0;
    const TinkerBlockId *blocks = NULL;
    if (canvas->document != NULL) blocks = tinker_document_selection(canvas->document, &count);
    if (count == 1) return tinker_block_words(tinker_document_scene(canvas->document), blocks[0]);
    if (count == 0) return g_strdup(_("nothing is selected"));
    return g_strdup_printf(ngettext("%d block is selected", "%d blocks are selected", (gulong)count), count);
}

/* For those who cannot see it, and for tests, which find places by it: six digits are finer than a pixel. */
void canvas_describe_view(TinkerCanvas *canvas)
{
    const TinkerView *view = &canvas->view;
    double middle[2];
    canvas_to_world(canvas, view->width / 2, view->height / 2, middle);
    g_autofree char *selection = selection_words(canvas);
    g_autofree char *shown =
        g_strdup_printf(_("Shows %.6g m by %.6g m about (%.6g, %.6g); %s"), view->width / view->scale,
                        view->height / view->scale, middle[0], middle[1], selection);
    /* first what keys have come to: who goes from arrow to arrow does not hear the rest again */
    const char *reached = canvas->reached_text;
    g_autofree char *text = reached != NULL ? g_strdup_printf("%s; %s", reached, shown) : g_steal_pointer(&shown);
    gtk_accessible_update_property(GTK_ACCESSIBLE(canvas), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, text, -1);
}

void canvas_view_changed(TinkerCanvas *canvas)
{
    canvas->view_is_fitted = FALSE;
    canvas->view.scale = CLAMP(canvas->view.scale, LEAST_SCALE, GREATEST_SCALE);
    canvas_describe_view(canvas);
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
    g_signal_emit_by_name(canvas, "view-changed");
}

GPtrArray *canvas_panels(TinkerCanvas *canvas, double factor)
{
    g_autoptr(GArray) boxes = g_array_new(FALSE, FALSE, 4 * sizeof(double));
    GPtrArray *texts = tinker_written_texts_new();
    if (canvas->view.covered > 0)
        g_array_append_vals(boxes, ((double[]){0, 0, canvas->view.width, canvas->view.covered}), 1);
    g_signal_emit_by_name(canvas, "panels", boxes);
    for (guint i = 0; i < boxes->len; i++) {
        const double *box = (const double *)(gpointer)boxes->data + 4 * (gsize)i;
        TinkerWrittenText *panel = g_new0(TinkerWrittenText, 1);
        for (int k = 0; k < 4; k++)
            panel->box[k] = box[k] / factor;
        g_ptr_array_add(texts, panel);
    }
    return texts;
}
