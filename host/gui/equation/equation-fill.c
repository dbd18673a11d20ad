#include "gui/equation/equation-fill.h"

#define SLICE_US 8000 /* of making rows; half a frame at 60 Hz */
#define PAUSE    5    /* ms: between slices, for events and frames */

struct TinkerEquationFill {
    TinkerDocument *document;
    GSourceFunc done;
    gpointer data;
    GtkWidget *rows, *rest;
    GPtrArray *shown, *spoken; /* of TinkerEquationLine; NULL: nothing is to come */
    guint row_count, next;
    guint source; /* 0: none */
};

TinkerEquationFill *tinker_equation_fill_new(TinkerDocument *document, GSourceFunc done, gpointer data)
{
    TinkerEquationFill *fill = g_new0(TinkerEquationFill, 1);
    *fill = (TinkerEquationFill){.document = g_object_ref(document), .done = done, .data = data};
    return fill;
}

static gboolean fill_slice(gpointer data)
{
    TinkerEquationFill *fill = data;
    const gint64 until = g_get_monotonic_time() + SLICE_US;
    for (; fill->next < fill->shown->len; fill->next++) {
        if (g_get_monotonic_time() > until) return G_SOURCE_CONTINUE;
        tinker_equation_list_add(fill->next < fill->row_count ? fill->rows : fill->rest, fill->document,
                                 g_ptr_array_index(fill->shown, fill->next),
                                 g_ptr_array_index(fill->spoken, fill->next));
    }
    fill->source = 0; /* ends below */
    tinker_equation_fill_stop(fill);
    fill->done(fill->data);
    return G_SOURCE_REMOVE;
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
    /* Not behind frames: where these take all of the time, an idle source would never come. */
    if (fill_slice(fill)) fill->source = g_timeout_add(PAUSE, fill_slice, fill);
}

gboolean tinker_equation_fill_is_going(const TinkerEquationFill *fill)
{
    return fill->shown != NULL;
}

void tinker_equation_fill_stop(TinkerEquationFill *fill)
{
    g_clear_handle_id(&fill->source, g_source_remove);
    g_clear_pointer(&fill->shown, g_ptr_array_unref);
    g_clear_pointer(&fill->spoken, g_ptr_array_unref);
}

void tinker_equation_fill_free(TinkerEquationFill *fill)
{
    tinker_equation_fill_stop(fill);
    g_object_unref(fill->document);
    g_free(fill);
}
