/* The bodies that a diagram is of: where they are on a part of the paper, drawn by the painter. */
#include <math.h>

#include "common/diagram/diagram-picture-private.h"
#include "render/picture/painter.h"

#define BODY_SHARE 0.3  /* of the lesser side of its part of the paper, for one body; */
#define WIDE_SHARE 0.42 /* for several */

/* The world box of what the diagram is of. */
static void find_box(const DiagramDrawing *drawing, double box[4])
{
    const TinkerView view = {.scale = 1e6, .width = 800, .height = 600};
    double own[4];
    box[0] = box[1] = INFINITY;
    box[2] = box[3] = -INFINITY;
    for (const TinkerBlockId *block = drawing->picture->blocks; *block >= 0; block++)
        if (tinker_painter_box(drawing->picture->frame, *block, &view, own)) {
            box[0] = fmin(box[0], own[0]);
            box[1] = fmin(box[1], own[1]);
            box[2] = fmax(box[2], own[2]);
            box[3] = fmax(box[3], own[3]);
        }
    if (box[0] <= box[2]) return;
    for (int side = 0; side < 4; side++)
        box[side] = drawing->picture->diagram->centre[side % 2];
}

/* Of a support that is far longer than what acts on it, the part about the forces. */
static void cut_box(const DiagramDrawing *drawing, double box[4])
{
    const TinkerDiagram *diagram = drawing->picture->diagram;
    if (diagram->moves || drawing->forces->len == 0) return;
    double about[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (guint i = 0; i < drawing->forces->len; i++) {
        const double *point = g_array_index(drawing->forces, TinkerDiagramForce, i).point;
        for (int axis = 0; axis < 2; axis++) {
            about[axis] = fmin(about[axis], point[axis]);
            about[axis + 2] = fmax(about[axis + 2], point[axis]);
        }
    }
    const double thin = fmin(box[2] - box[0], box[3] - box[1]);
    const double room = fmax(4 * thin, 0.3 * fmax(about[2] - about[0], about[3] - about[1]));
    for (int axis = 0; axis < 2; axis++) {
        box[axis] = fmax(box[axis], about[axis] - room);
        box[axis + 2] = fmin(box[axis + 2], about[axis + 2] + room);
    }
}

GArray *diagram_drawn_boxes(const DiagramDrawing *drawing, const TinkerView *view)
{
    GArray *boxes = g_array_new(FALSE, FALSE, 4 * sizeof(double));
    for (const TinkerBlockId *block = drawing->picture->blocks; *block >= 0; block++) {
        double world[4], box[4];
        if (!tinker_painter_box(drawing->picture->frame, *block, view, world)) continue;
        tinker_view_to_canvas(view, world[0], world[3], &box[0], &box[1]);
        tinker_view_to_canvas(view, world[2], world[1], &box[2], &box[3]);
        g_array_append_vals(boxes, box, 1);
    }
    return boxes;
}

double diagram_body_room(const DiagramDrawing *drawing)
{
    return fmin(BODY_SHARE * drawing->lesser, DIAGRAM_MOST_BODY);
}

TinkerView diagram_view(const DiagramDrawing *drawing, double width, double height)
{
    double box[4];
    find_box(drawing, box);
    cut_box(drawing, box);
    const gboolean several = drawing->picture->blocks[0] >= 0 && drawing->picture->blocks[1] >= 0;
    const double room = several ? WIDE_SHARE * drawing->lesser : diagram_body_room(drawing);
    const double extent = fmax(fmax(box[2] - box[0], box[3] - box[1]), 1e-9);
    const double scale = room / extent;
    return (TinkerView){.scale = scale,
                        .origin_x = width / 2 - scale * (box[0] + box[2]) / 2,
                        .origin_y = height / 2 + scale * (box[1] + box[3]) / 2,
                        .width = width,
                        .height = height};
}

void diagram_draw_bodies(DiagramDrawing *drawing, const TinkerView *view)
{
    TinkerTheme theme = *drawing->picture->theme;
    TinkerPaintOptions options = tinker_paint_options_default();
    theme.background[3] = 0;
    options.theme = &theme;
    options.only = drawing->picture->blocks;
    options.show_grid = options.show_labels = FALSE;
    tinker_paint_scene(drawing->cairo, drawing->picture->frame, view, &options);
}
