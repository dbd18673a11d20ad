/* The forces of a diagram in numbers. */
#include <glib/gi18n.h>
#include <math.h>

#include "diagram-picture-private.h"

#define NOTHING   1e-12 /* components below this share of the greatest force are 0 */
#define MOST_ROWS 10
#define NARROW    560.0 /* canvas units: below it partners are left out */

/* The list -----------------------------------------------------------------------------------------------------------
 */

enum { NAME, ALONG_X, ALONG_Y, SIZE, PARTNER, COLUMNS };

typedef struct {
    const double *colour; /* NULL: none */
    char *texts[COLUMNS];
    gboolean bold;
} ListRow;

static void list_row_clear(gpointer data)
{
    ListRow *row = data;
    for (int i = 0; i < COLUMNS; i++)
        g_free(row->texts[i]);
}

static void add_row(const DiagramDrawing *drawing, GArray *rows, char *name, const double force[2],
                    const double *colour, char *partner)
{
    const double least = NOTHING * diagram_greatest_force(drawing->picture->diagram);
    double shown[2]; /* without what rounding leaves */
    for (int axis = 0; axis < 2; axis++)
        shown[axis] = fabs(force[axis]) > least ? force[axis] : 0;
    const ListRow row = {colour,
                         {name, diagram_force_text(drawing, shown[0]), diagram_force_text(drawing, shown[1]),
                          diagram_force_text(drawing, diagram_strength(force)), partner}};
    g_array_append_val(rows, row);
}

/* What the columns are. */
static void add_head(GArray *rows)
{
    const ListRow head = {NULL,
                          {g_strdup(_("Force")), g_strdup(_("along x")), g_strdup(_("along y")),
                           g_strdup(C_("of a force", "size")), g_strdup(_("partner"))},
                          TRUE};
    g_array_append_val(rows, head);
}

/* A head, the forces, what they make, and notes in the first column. (transfer full) */
static GArray *list_of(const DiagramDrawing *drawing)
{
    const TinkerTheme *theme = drawing->picture->theme;
    const TinkerDiagram *diagram = drawing->picture->diagram;
    GArray *rows = g_array_new(FALSE, TRUE, sizeof(ListRow));
    g_array_set_clear_func(rows, list_row_clear);
    if (drawing->forces->len > 0 || diagram->moves) add_head(rows);
    for (guint i = 0; i < drawing->forces->len && i < MOST_ROWS; i++) {
        const TinkerDiagramForce *force = &g_array_index(drawing->forces, TinkerDiagramForce, i);
        char *partner = force->partner < 0 ? g_strdup("")
                                           : g_strdup_printf(_("opposite on %s"),
                                                             tinker_scene_block_name(drawing->scene, force->partner));
        add_row(drawing, rows, diagram_force_name(drawing, force), force->force,
                tinker_arrow_colour(theme, diagram_arrow_kind(force->kind)), partner);
    }
    if (drawing->forces->len > MOST_ROWS) {
        const ListRow more = {NULL, {g_strdup_printf(_("and %u more"), drawing->forces->len - MOST_ROWS)}};
        g_array_append_val(rows, more);
    }
    if (diagram->moves) {
        static const double none[2] = {0, 0};
        add_row(drawing, rows, g_strdup(_("together = m a")), diagram_has_resultant(diagram) ? diagram->kinetic : none,
                tinker_arrow_colour(theme, TINKER_ARROW_MOTION), g_strdup(""));
    }
    g_autoptr(GPtrArray) notes = diagram_notes(drawing);
    for (guint i = 0; i < notes->len; i++) {
        const ListRow note = {NULL, {g_strdup(g_ptr_array_index(notes, i))}};
        g_array_append_val(rows, note);
    }
    return rows;
}

double diagram_list_height(const DiagramDrawing *drawing)
{
    g_autoptr(GArray) rows = list_of(drawing);
    return DIAGRAM_ROW * rows->len;
}

void diagram_draw_list(DiagramDrawing *drawing, double width, double top)
{
    g_autoptr(GArray) rows = list_of(drawing);
    /* where columns end, for numbers, or begin */
    const gboolean narrow = width < NARROW;
    const double wide_ends[COLUMNS] = {DIAGRAM_EDGE + 14, 0.46 * width, 0.58 * width, 0.7 * width, 0.72 * width};
    const double narrow_ends[COLUMNS] = {DIAGRAM_EDGE + 14, 0.6 * width, 0.8 * width, 0.99 * width, width};
    const double *ends = narrow ? narrow_ends : wide_ends;
    for (guint i = 0; i < rows->len; i++) {
        const ListRow *row = &g_array_index(rows, ListRow, i);
        const double y = top + DIAGRAM_ROW * (i + 0.5);
        if (row->colour != NULL) {
            diagram_set_colour(drawing->cairo, row->colour);
            cairo_rectangle(drawing->cairo, DIAGRAM_EDGE, y - 4, 8, 8);
            cairo_fill(drawing->cairo);
        }
        for (int k = 0; k < COLUMNS; k++) {
            const gboolean number = k >= ALONG_X && k <= SIZE, whole = row->texts[ALONG_X] == NULL;
            if (row->texts[k] == NULL || (narrow && k == PARTNER)) continue;
            const double limit = whole          ? width - 2 * DIAGRAM_EDGE
                                 : k == NAME    ? 0.3 * width
                                 : k == PARTNER ? 0.28 * width - DIAGRAM_EDGE
                                                : 0;
            diagram_write(drawing,
                          (TinkerText){.text = row->texts[k],
                                       .size = DIAGRAM_TEXT,
                                       .bold = row->bold,
                                       .keeps_end = !whole && k == NAME,
                                       .limit = fmax(limit, 0),
                                       .anchor_x = number,
                                       .anchor_y = 0.5},
                          ends[k], y);
        }
    }
}
