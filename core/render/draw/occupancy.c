/* The map is a plain array of bytes; its cells are a few canvas units wide, which is as near as a label should come. */
#include "render/draw/occupancy.h"

#include <math.h>

#define GREATEST_CELLS 4096 /* along either side */

void tinker_occupancy_init(TinkerOccupancy *map, double left, double top, double width, double height, double cell)
{
    map->left = left;
    map->top = top;
    map->cell = fmax(cell, fmax(width, height) / GREATEST_CELLS);
    map->columns = MAX((int)ceil(width / map->cell), 1);
    map->rows = MAX((int)ceil(height / map->cell), 1);
    map->taken = g_new0(guint8, (gsize)map->columns * (gsize)map->rows);
}

void tinker_occupancy_clear(TinkerOccupancy *map)
{
    g_clear_pointer(&map->taken, g_free);
}

static int cell_of(double place, double start, double cell, int count)
{
    double index = floor((place - start) / cell);
    return (int)CLAMP(index, -1, count);
}

/* The cells of a box: first and last column, first and last row; -1 and the number of cells are outside. */
static gboolean cells_of(const TinkerOccupancy *map, const double box[4], int cells[4])
{
    for (int i = 0; i < 4; i++)
        if (!isfinite(box[i])) return FALSE;
    cells[0] = cell_of(box[0], map->left, map->cell, map->columns);
    cells[1] = cell_of(box[2], map->left, map->cell, map->columns);
    cells[2] = cell_of(box[1], map->top, map->cell, map->rows);
    cells[3] = cell_of(box[3], map->top, map->cell, map->rows);
    return TRUE;
}

void tinker_occupancy_take_box(TinkerOccupancy *map, const double box[4], guint8 by)
{
    int cells[4];
    if (!cells_of(map, box, cells)) return;
    for (int row = MAX(cells[2], 0); row <= MIN(cells[3], map->rows - 1); row++)
        for (int column = MAX(cells[0], 0); column <= MIN(cells[1], map->columns - 1); column++)
            map->taken[(gsize)row * (gsize)map->columns + (gsize)column] |= by;
}

void tinker_occupancy_take_line(TinkerOccupancy *map, double x1, double y1, double x2, double y2, double thickness,
                                guint8 by)
{
    double length = hypot(x2 - x1, y2 - y1), half = thickness / 2;
    if (!isfinite(length)) return;
    /* Boxes along the line, not farther apart than a cell, and not more than the map could show. */
    double across = map->cell * (map->columns + map->rows);
    if (length > 100 * across) return;
    int steps = (int)ceil(length / fmax(map->cell, half));
    for (int i = 0; i <= steps; i++) {
        double t = steps ? (double)i / steps : 0;
        double x = x1 + t * (x2 - x1), y = y1 + t * (y2 - y1);
        tinker_occupancy_take_box(map, (double[]){x - half, y - half, x + half, y + half}, by);
    }
}

double tinker_occupancy_share(const TinkerOccupancy *map, const double box[4], guint8 by)
{
    int cells[4], taken = 0;
    if (!cells_of(map, box, cells)) return 1;
    for (int row = cells[2]; row <= cells[3]; row++)
        for (int column = cells[0]; column <= cells[1]; column++) {
            gboolean outside = row < 0 || row >= map->rows || column < 0 || column >= map->columns;
            if (outside || (map->taken[(gsize)row * (gsize)map->columns + (gsize)column] & by)) taken++;
        }
    return (double)taken / ((double)(cells[1] - cells[0] + 1) * (cells[3] - cells[2] + 1));
}
