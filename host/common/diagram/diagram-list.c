/* The forces of a diagram in numbers. */
#include <glib/gi18n.h>
#include <math.h>

#include "common/diagram/diagram-picture-private.h"

#define MOST_ROWS 10
#define NARROW    560.0 /* canvas units: below it partners are left out, */
#define NARROWEST 330.0 /* and below this what is along x and y */
#define INDENT    14.0  /* of names, behind the colour of their arrow */
#define LIT       0.2   /* of its colour, the ground of what is pointed at */
#define GAP       8.0   /* from a name to what stands behind it */

/* The list --------------------------------------------------------------------------------------------------------- */

enum { NAME, ALONG_X, ALONG_Y, SIZE, PARTNER, COLUMNS };

typedef struct {
    const double *colour; /* NULL: none */
    char *texts[COLUMNS];
    gboolean bold;
    int lines;                    /* that it may take; 0 is one */
    double room;                  /* canvas units: for its name */
    const TinkerDiagramForce *of; /* NULL: of none */
} ListRow;

static void list_row_clear(gpointer data)
{
    ListRow *row = data;
    for (int i = 0; i < COLUMNS; i++)
        g_free(row->texts[i]);
}

static void add_row(const DiagramDrawing *drawing, GArray *rows, char *name, const double force[2],
                    const double *colour, char *partner, const TinkerDiagramForce *of)
{
    const double least = TINKER_FORCE_NOTHING * diagram_greatest_force(drawing->picture->diagram);
    double shown[2]; /* without what rounding leaves */
    for (int axis = 0; axis < 2; axis++)
        shown[axis] = fabs(force[axis]) > least ? force[axis] : 0;
    const ListRow row = {.colour = colour,
                         .texts = {name, diagram_force_text(drawing, shown[0]), diagram_force_text(drawing, shown[1]),
                                   diagram_force_text(drawing, diagram_strength(force)), partner},
                         .of = of};
    g_array_append_val(rows, row);
}

/* What turns a body stands with its size alone. */
static void add_torque(const DiagramDrawing *drawing, GArray *rows, char *name, double torque, const double *colour,
                       const TinkerDiagramForce *of)
{
    const ListRow row = {
        .colour = colour,
        .texts = {name, g_strdup(""), g_strdup(""), diagram_torque_text(drawing, torque), g_strdup("")},
        .of = of};
    g_array_append_val(rows, row);
}

static void add_torques(const DiagramDrawing *drawing, GArray *rows)
{
    for (guint i = 0; i < drawing->torques->len; i++) {
        const TinkerDiagramForce *torque = &g_array_index(drawing->torques, TinkerDiagramForce, i);
        const char *from = tinker_scene_block_name(drawing->scene, torque->from);
        g_autofree char *number =
            drawing->numbered ? g_strdup_printf("%u  ", drawing->forces->len + i + 1) : g_strdup("");
        g_autofree char *name = g_strdup_printf(_("%s, torque"), from);
        add_torque(drawing, rows, g_strconcat(number, name, NULL), torque->torque,
                   tinker_arrow_colour(drawing->picture->theme, diagram_arrow_kind(torque->kind)), torque);
    }
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

/* (transfer full) */
static char *name_of(const DiagramDrawing *drawing, guint number)
{
    g_autofree char *name = diagram_force_name(drawing, &g_array_index(drawing->forces, TinkerDiagramForce, number));
    return drawing->numbered ? g_strdup_printf("%u  %s", number + 1, name) : g_steal_pointer(&name);
}

/* On whom the opposite is; of a rope over a wheel where its two spans go. (transfer full) */
static char *partner_of(const DiagramDrawing *drawing, const TinkerDiagramForce *force)
{
    if (force->partner < 0) return g_strdup("");
    const char *partner = tinker_scene_block_name(drawing->scene, force->partner);
    return force->second < 0
               ? g_strdup_printf(_("opposite on %s"), partner)
               : g_strdup_printf(_("on to %s and %s"), partner, tinker_scene_block_name(drawing->scene, force->second));
}

/* What is listed. */
typedef struct {
    guint most; /* forces */
    gboolean notes;
} ListChoice;

/* Where columns end, for numbers, or begin; below 0 for those that are left out. */
static const double *ends_of(double width)
{
    static const double wide[COLUMNS] = {0, 0.43, 0.565, 0.7, 0.72}, narrow[COLUMNS] = {0, 0.6, 0.8, 0.98, -1},
                        narrowest[COLUMNS] = {0, -1, -1, 0.95, -1};
    return width < NARROWEST ? narrowest : width < NARROW ? narrow : wide;
}

/* Canvas units: where columns end or begin, at their places as long as no number reaches into another: then those
 * before it make way to the left. */
static void place_columns(DiagramDrawing *drawing, const GArray *rows, double width, double places[COLUMNS])
{
    const double *ends = ends_of(width);
    double next = width;
    for (int k = 0; k < COLUMNS; k++)
        places[k] = ends[k] < 0 ? -1 : ends[k] * width;
    for (int k = SIZE; k >= ALONG_X; k--) {
        double widest = 0;
        if (places[k] < 0) continue;
        for (guint i = 0; i < rows->len; i++) {
            const ListRow *row = &g_array_index(rows, ListRow, i);
            if (row->texts[k] != NULL) widest = fmax(widest, diagram_text_width(drawing, row->texts[k], row->bold));
        }
        places[k] = fmin(places[k], next);
        next = places[k] - widest - GAP;
    }
}

/* Canvas units: of the column of partners. */
static double partner_room(double width)
{
    return 0.28 * width - DIAGRAM_EDGE;
}

/* A name has the room up to the first number of its row; it, and a partner, have two lines where they are longer. */
static void fit_names(DiagramDrawing *drawing, GArray *rows, double width)
{
    double places[COLUMNS];
    place_columns(drawing, rows, width, places);
    for (guint i = 0; i < rows->len; i++) {
        ListRow *row = &g_array_index(rows, ListRow, i);
        double end = width;
        if (row->texts[ALONG_X] == NULL) continue; /* a note */
        for (int k = ALONG_X; k <= SIZE; k++)
            if (places[k] >= 0 && row->texts[k][0] != '\0')
                end = fmin(end, places[k] - diagram_text_width(drawing, row->texts[k], row->bold));
        row->room = fmax(end - DIAGRAM_EDGE - INDENT - GAP, 1);
        const gboolean long_partner =
            places[PARTNER] >= 0 && diagram_text_width(drawing, row->texts[PARTNER], row->bold) > partner_room(width);
        const gboolean long_name = diagram_text_width(drawing, row->texts[NAME], row->bold) > row->room;
        row->lines = long_name || long_partner ? 2 : 1;
    }
}

/* A head, the forces, what they make, and notes in the first column. (transfer full) */
static GArray *list_of(DiagramDrawing *drawing, double width, ListChoice choice)
{
    const guint most = choice.most;
    const TinkerTheme *theme = drawing->picture->theme;
    const TinkerDiagram *diagram = drawing->picture->diagram;
    GArray *rows = g_array_new(FALSE, TRUE, sizeof(ListRow));
    g_array_set_clear_func(rows, list_row_clear);
    if (drawing->forces->len + drawing->torques->len > 0 || diagram->moves) add_head(rows);
    for (guint i = 0; i < drawing->forces->len && i < most; i++) {
        const TinkerDiagramForce *force = &g_array_index(drawing->forces, TinkerDiagramForce, i);
        add_row(drawing, rows, name_of(drawing, i), force->force,
                tinker_arrow_colour(theme, diagram_arrow_kind(force->kind)), partner_of(drawing, force), force);
    }
    if (drawing->forces->len > most) {
        const ListRow more = {NULL, {g_strdup_printf(_("and %u more"), drawing->forces->len - most)}};
        g_array_append_val(rows, more);
    }
    add_torques(drawing, rows);
    if (diagram->moves) {
        static const double none[2] = {0, 0};
        add_row(drawing, rows, g_strdup(width < NARROWEST ? "= m a" : _("together = m a")),
                diagram_has_resultant(diagram) ? diagram->kinetic : none,
                tinker_arrow_colour(theme, TINKER_ARROW_MOTION), g_strdup(""), NULL);
        if (!isnan(diagram->inertia))
            add_torque(drawing, rows, g_strdup("I α"), diagram_has_turning(diagram) ? diagram->turning : 0,
                       tinker_arrow_colour(theme, TINKER_ARROW_MOTION), NULL);
    }
    g_autoptr(GPtrArray) notes = diagram_notes(drawing);
    for (guint i = 0; choice.notes && i < notes->len; i++) {
        const ListRow note = {NULL, {g_strdup(g_ptr_array_index(notes, i))}, FALSE, width < NARROWEST ? 2 : 1};
        g_array_append_val(rows, note);
    }
    fit_names(drawing, rows, width);
    return rows;
}

static double height_of(const GArray *rows)
{
    double height = 0;
    for (guint i = 0; i < rows->len; i++)
        height += DIAGRAM_ROW * MAX(g_array_index(rows, ListRow, i).lines, 1);
    return height;
}

double diagram_list_height(DiagramDrawing *drawing, double width)
{
    g_autoptr(GArray) rows = list_of(drawing, width, (ListChoice){MOST_ROWS, TRUE});
    return height_of(rows);
}

/* What the row says, and where it is. */
static void add_spot(DiagramDrawing *drawing, const ListRow *row, double width, double y)
{
    const double half = DIAGRAM_ROW * MAX(row->lines, 1) / 2, box[] = {0, y - half, width, y + half};
    g_autofree char *name = diagram_force_name(drawing, row->of);
    g_autofree char *text = g_strdup_printf("%s  %s", name, row->texts[SIZE]);
    tinker_spots_add_box(drawing->picture->spots, box, diagram_pointed(row->of), text);
}

/* The ground of what is pointed at. */
static void draw_lit(DiagramDrawing *drawing, double width, double y, double height)
{
    const double *colour = drawing->picture->theme->colours[TINKER_COLOUR_SELECTED];
    cairo_set_source_rgba(drawing->cairo, colour[0], colour[1], colour[2], LIT);
    cairo_rectangle(drawing->cairo, DIAGRAM_EDGE / 2, y - height / 2, width - DIAGRAM_EDGE, height);
    cairo_fill(drawing->cairo);
}

static void draw_row(DiagramDrawing *drawing, const ListRow *row, const double places[COLUMNS], double width, double y)
{
    const TinkerPointed thing = row->of != NULL ? diagram_pointed(row->of) : tinker_pointed_block(TINKER_NO_BLOCK);
    if (tinker_pointed_lights(drawing->picture->lit, &thing))
        draw_lit(drawing, width, y, DIAGRAM_ROW * MAX(row->lines, 1));
    if (row->of != NULL && drawing->picture->spots != NULL) add_spot(drawing, row, width, y);
    const gboolean whole = row->texts[ALONG_X] == NULL;
    if (row->colour != NULL) {
        diagram_set_colour(drawing->cairo, row->colour);
        cairo_rectangle(drawing->cairo, DIAGRAM_EDGE, y - 4, 8, 8);
        cairo_fill(drawing->cairo);
    }
    for (int k = 0; k < COLUMNS; k++) {
        const gboolean number = k >= ALONG_X && k <= SIZE;
        if (row->texts[k] == NULL || places[k] < 0) continue;
        const double limit = whole          ? width - 2 * DIAGRAM_EDGE
                             : k == NAME    ? row->room
                             : k == PARTNER ? partner_room(width)
                                            : 0;
        diagram_write(drawing,
                      (TinkerText){.text = row->texts[k],
                                   .size = DIAGRAM_TEXT,
                                   .bold = row->bold,
                                   .limit = fmax(limit, 0),
                                   .lines = number ? 1 : row->lines,
                                   .anchor_x = number,
                                   .anchor_y = 0.5},
                      k == NAME ? DIAGRAM_EDGE + (whole ? 0 : INDENT) : places[k], y);
    }
}

void diagram_draw_list(DiagramDrawing *drawing, const double place[4])
{
    const double width = place[2] - place[0];
    ListChoice choice = {MIN(MOST_ROWS, drawing->forces->len), TRUE};
    GArray *rows = list_of(drawing, width, choice);
    while ((choice.notes || choice.most > 1) && height_of(rows) > place[3] - place[1]) {
        choice.most -= choice.notes ? 0 : 1;
        choice.notes = FALSE;
        g_array_unref(rows);
        rows = list_of(drawing, width, choice);
    }
    double y = place[1], places[COLUMNS];
    place_columns(drawing, rows, width, places);
    for (guint i = 0; i < rows->len; i++) {
        const ListRow *row = &g_array_index(rows, ListRow, i);
        const double height = DIAGRAM_ROW * MAX(row->lines, 1);
        cairo_save(drawing->cairo);
        draw_row(drawing, row, places, width, y + height / 2);
        cairo_restore(drawing->cairo);
        y += height;
    }
    g_array_unref(rows);
}
