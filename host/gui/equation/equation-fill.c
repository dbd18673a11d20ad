#include "gui/equation/equation-fill.h"

#define SLICE_US 6000 /* of making rows, in each frame */

struct TinkerEquationFill {
    TinkerDocument *document;
    TinkerFilledFunc done;
    gpointer data;
    GtkWidget *rows, *rest;
    GPtrArray *shown, *spoken; /* of TinkerEquationLine; NULL: nothing is to come */
    guint row_count, next;
    guint tick; /* 0: none */
};

TinkerEquationFill *tinker_equation_fill_new(TinkerDocument *document, TinkerFilledFunc done, gpointer data)
{
    TinkerEquationFill *fill = g_new0(TinkerEquationFill, 1);
    *fill = (TinkerEquationFill){.document = g_object_ref(document), .done = done, .data = data};
    return fill;
}

/* FALSE: all lines are shown. */
static gboolean fill_slice(TinkerEquationFill *fill)
{
    const gint64 until = g_get_monotonic_time() + SLICE_US;
    for (; fill->next < fill->shown->len; fill->next++) {
        if (g_get_monotonic_time() > until) return TRUE;
        tinker_equation_list_add(fill->next < fill->row_count ? fill->rows : fill->rest, fill->document,
                                 g_ptr_array_index(fill->shown, fill->next),
                                 g_ptr_array_index(fill->spoken, fill->next));
    }
    tinker_equation_fill_stop(fill);
    fill->done(fill->data);
    return FALSE;
}

static gboolean on_tick(GtkWidget *rows, GdkFrameClock *clock, gpointer fill)
{
    fill_slice(fill); /* which removes this callback in the end */
    return G_SOURCE_CONTINUE;
}

void tinker_equation_fill_start(TinkerEquationFill *fill, GtkWidget *rows, GtkWidget *rest, guint row_count,
                                GPtrArray *shown, GPtrArray *spoken)
{
    tinker_equation_fill_stop(fill);
    fill->rows = rows;
    fill->rest = rest;
    fill->row_count = row_count;
    fill->shown = shown;
    fill->spoken = spoken;
    fill->next = 0;
    /* With each frame, so that neither waits for the other. */
    if (fill_slice(fill)) fill->tick = gtk_widget_add_tick_callback(rows, on_tick, fill, NULL);
}

gboolean tinker_equation_fill_is_going(const TinkerEquationFill *fill)
{
    return fill->shown != NULL;
}

void tinker_equation_fill_stop(TinkerEquationFill *fill)
{
    if (fill->tick != 0) gtk_widget_remove_tick_callback(fill->rows, fill->tick);
    fill->tick = 0;
    g_clear_pointer(&fill->shown, g_ptr_array_unref);
    g_clear_pointer(&fill->spoken, g_ptr_array_unref);
}

void tinker_equation_fill_free(TinkerEquationFill *fill)
{
    tinker_equation_fill_stop(fill);
    g_object_unref(fill->document);
    g_free(fill);
}
