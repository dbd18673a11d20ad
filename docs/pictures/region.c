/* Shades are bands, one a column of the grid; edges are the lines of marching squares. Both pass between two places
 * of the grid where a straight line between their growths does. */
#include "region.h"

#include <math.h>
#include <string.h>

#define COLUMNS        480
#define ROWS           360
#define MOST_INTERVALS 4 /* of a column */
#define POINTS_OF_BAND 3 /* from side to side of the column, and a gap */

static double x_of(const Grid *grid, double column)
{
    return grid->view[0] + (grid->view[1] - grid->view[0]) * column / (COLUMNS - 1);
}

static double y_of(const Grid *grid, double row)
{
    return grid->view[2] + (grid->view[3] - grid->view[2]) * row / (ROWS - 1);
}

static double growth_at(const Grid *grid, int column, int row)
{
    return grid->growth[column * ROWS + row];
}

void docs_grid_init(Grid *grid, const Method *method, const double *view)
{
    grid->view = view;
    grid->growth = g_new(double, (gsize)COLUMNS *ROWS);
    for (int column = 0; column < COLUMNS; column++)
        for (int row = 0; row < ROWS; row++) {
            double growth = method->growth(method, x_of(grid, column), y_of(grid, row));
            grid->growth[column * ROWS + row] = fmin(growth, 1e3);
        }
}

void docs_grid_clear(Grid *grid)
{
    g_free(grid->growth);
}

static double *new_numbers(GPtrArray *numbers, gsize count)
{
    double *made = g_new(double, count);
    g_ptr_array_add(numbers, made);
    return made;
}

/* Shades
 * --------------------------------------------------------------------------------------------------------------- */

/* Where between two places growth passes the level, as a share of the way. */
static double passing(double from, double to, double level)
{
    return CLAMP((level - from) / (to - from), 0, 1);
}

/* The stretches of a column where growth is at most the level: lower ends and upper ends. Answers how many. */
static int find_intervals(const Grid *grid, int column, double level, double ends[MOST_INTERVALS][2])
{
    int found = 0;
    gboolean inside = FALSE;
    for (int row = 0; row < ROWS; row++) {
        double here = growth_at(grid, column, row), before = row > 0 ? growth_at(grid, column, row - 1) : here;
        double edge = row > 0 ? row - 1 + passing(before, here, level) : 0;
        gboolean was_inside = inside;
        inside = here <= level;
        if (inside && !was_inside) {
            if (found == MOST_INTERVALS) return found;
            ends[found][0] = y_of(grid, edge);
            ends[found++][1] = grid->view[3];
        } else if (was_inside && !inside) {
            ends[found - 1][1] = y_of(grid, edge);
        }
    }
    return found;
}

/* Each column is a band of its own, so that it does not matter how many stretches its neighbours have. */
void docs_add_shade(GArray *curves, GPtrArray *numbers, const Grid *grid, double level, int colour)
{
    gsize points = (gsize)COLUMNS * MOST_INTERVALS * POINTS_OF_BAND, made = 0;
    double *x = new_numbers(numbers, points), *y = new_numbers(numbers, points);
    double *low = new_numbers(numbers, points), *high = new_numbers(numbers, points);
    for (int column = 0; column < COLUMNS; column++) {
        double ends[MOST_INTERVALS][2];
        int found = find_intervals(grid, column, level, ends);
        for (int k = 0; k < found; k++)
            for (int point = 0; point < POINTS_OF_BAND; point++, made++) {
                x[made] = x_of(grid, CLAMP(column + point - 0.5, 0, COLUMNS - 1));
                y[made] = NAN;
                low[made] = point < 2 ? ends[k][0] : NAN;
                high[made] = point < 2 ? ends[k][1] : NAN;
            }
    }
    TinkerCurve shade = {.x = x, .y = y, .low = low, .high = high, .count = made, .colour = colour};
    g_array_append_val(curves, shade);
}

/* Edges
 * ---------------------------------------------------------------------------------------------------------------- */

static void append_point(GArray *line, double x, double y)
{
    g_array_append_vals(line, (double[]){x, y}, 1);
}

/* Where the level passes the four sides of a cell, joined two by two. */
static void add_cell(const Grid *grid, int column, int row, double level, GArray *line)
{
    static const int corners[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    int found = 0;
    for (int side = 0; side < 4; side++) {
        const int *a = corners[side], *b = corners[side + 1];
        double from = growth_at(grid, column + a[0], row + a[1]), to = growth_at(grid, column + b[0], row + b[1]);
        if ((from <= level) == (to <= level)) continue;
        double share = passing(from, to, level);
        append_point(line, x_of(grid, column + a[0] + share * (b[0] - a[0])),
                     y_of(grid, row + a[1] + share * (b[1] - a[1])));
        if (++found % 2 == 0) append_point(line, NAN, NAN);
    }
}

static void add_points(GArray *curves, GPtrArray *numbers, GArray *line, TinkerCurve style)
{
    double *x = new_numbers(numbers, line->len), *y = new_numbers(numbers, line->len);
    for (guint i = 0; i < line->len; i++) {
        const double *point = (const double *)(const void *)line->data + 2 * i;
        x[i] = point[0];
        y[i] = point[1];
    }
    style.x = x;
    style.y = y;
    style.count = line->len;
    g_array_append_val(curves, style);
}

void docs_add_edge(GArray *curves, GPtrArray *numbers, const Grid *grid, double level, const char *label, int colour)
{
    g_autoptr(GArray) line = g_array_new(FALSE, FALSE, 2 * sizeof(double));
    for (int column = 0; column + 1 < COLUMNS; column++)
        for (int row = 0; row + 1 < ROWS; row++)
            add_cell(grid, column, row, level, line);
    if (line->len > 0) add_points(curves, numbers, line, (TinkerCurve){.label = label, .colour = colour});
}

void docs_add_curve(GArray *curves, GPtrArray *numbers, PlaceFunction place, const void *data, int points,
                    TinkerCurve style)
{
    g_autoptr(GArray) line = g_array_new(FALSE, FALSE, 2 * sizeof(double));
    for (int i = 0; i < points; i++) {
        double x, y;
        place(data, points > 1 ? i / (points - 1.0) : 0, &x, &y);
        append_point(line, x, y);
    }
    add_points(curves, numbers, line, style);
}
