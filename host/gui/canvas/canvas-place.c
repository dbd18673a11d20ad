/* New blocks: on their way from the palette, or put where there is room. */
#include <glib/gi18n.h>
#include <math.h>

#include "analysis/start/joined.h"
#include "gui/canvas/canvas-private.h"
#include "gui/text/translate.h"
#include "scene/history/first-size.h"

#define HALF_CONNECTOR 60.0 /* widget units: half the length of a connector that lies free */
#define ROOM           1.25 /* grid lines: between a new block and what is there */
#define GRIDS_APART    10   /* grid lines between the places that are looked at */
#define MOST_PLACES    400  /* that are looked at */

static double half_connector(TinkerCanvas *canvas)
{
    double grid = canvas_grid(canvas, 0), half = HALF_CONNECTOR / canvas->view.scale;
    return grid > 0 ? fmax(round(half / grid), 1) * grid : half;
}

/* Half the length at which a new block's ends lie apart. */
static double half_apart(TinkerCanvas *canvas, TinkerBlockId block)
{
    return tinker_is_joint(tinker_document_scene(canvas->document), block) ? 0 : half_connector(canvas);
}

/* Puts a free connector's ends onto what lies under them. */
static void connect_ends(TinkerCanvas *canvas, TinkerBlockId block)
{
    TinkerScene *scene = tinker_document_scene(canvas->document);
    if (tinker_is_joint(scene, block)) {
        const TinkerSceneEnd at = tinker_scene_end(scene, block, 0);
        tinker_joint_drop(tinker_document_history(canvas->document), scene, block, at.x, at.y, canvas_reach(canvas));
        return;
    }
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    for (int32_t i = 0; frame != NULL && i < tinker_scene_end_count(scene, block); i++) {
        TinkerSceneEnd end = tinker_scene_end(scene, block, i);
        if (end.block != TINKER_NO_BLOCK) continue;
        TinkerBlockId target = tinker_hit_connectable(frame, block, end.x, end.y, canvas_reach(canvas));
        if (target == TINKER_NO_BLOCK) continue;
        tinker_history_set_end(tinker_document_history(canvas->document), block, i, (TinkerSceneEnd){target, 0, 0},
                               NULL);
    }
}

void tinker_canvas_place_cancel(TinkerCanvas *canvas)
{
    if (canvas->placing == TINKER_NO_BLOCK) return;
    canvas->placing = TINKER_NO_BLOCK;
    tinker_document_abort(canvas->document);
}

void tinker_canvas_place_move(TinkerCanvas *canvas, const TinkerBlockClass *block_class, double x, double y)
{
    if (!gtk_widget_contains(GTK_WIDGET(canvas), x, y)) {
        tinker_canvas_place_cancel(canvas);
        return;
    }
    double place[2];
    canvas_to_world(canvas, x, y, place);
    tinker_snap(canvas_grid(canvas, 0), &place[0], &place[1]);
    if (canvas->placing == TINKER_NO_BLOCK) {
        if (tinker_player_time(canvas->player) > 0) tinker_player_rewind(canvas->player);
        g_autofree char *title = g_strdup_printf(_("Add %s"), tinker_translate(block_class->type->title));
        tinker_document_begin(canvas->document, title, NULL);
        canvas->placing = tinker_history_add_block(tinker_document_history(canvas->document), block_class, NULL, NULL);
        tinker_first_size(tinker_document_history(canvas->document), tinker_document_scene(canvas->document),
                          canvas->placing);
        tinker_document_select(canvas->document, canvas->placing);
    }
    tinker_document_place(canvas->document, canvas->placing, place, half_apart(canvas, canvas->placing));
    tinker_document_touch(canvas->document);
}

TinkerBlockId tinker_canvas_place_drop(TinkerCanvas *canvas)
{
    TinkerBlockId block = canvas->placing;
    if (block == TINKER_NO_BLOCK) return block;
    canvas->placing = TINKER_NO_BLOCK;
    connect_ends(canvas, block);
    tinker_snap_onto_top(tinker_document_history(canvas->document), tinker_document_scene(canvas->document), block,
                         canvas_top_reach(canvas));
    tinker_document_end(canvas->document);
    return block;
}

/* Whether a body of this half size would lie over another one. */
static gboolean is_free(TinkerFrame *frame, TinkerBlockId own, const double place[2], const double half[2])
{
    TinkerScene *scene = tinker_frame_scene(frame);
    const double room = ROOM * tinker_scene_head(scene)->canvas_grid;
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        TinkerBlockId block = tinker_scene_block_at(scene, i);
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
        if (block == own || block_class == NULL || block_class->meanings[TINKER_MEANING_POSITION] < 0) continue;
        double x, y, orientation, size[2];
        tinker_frame_centre(frame, block, &x, &y, &orientation);
        for (int k = 0; k < 2; k++) {
            int32_t column = tinker_block_class_meaning_column(block_class, TINKER_MEANING_WIDTH + k);
            size[k] = column >= 0 ? tinker_frame_column(frame, block, column) : 0;
        }
        if (fabs(x - place[0]) < half[0] + size[0] / 2 + room && fabs(y - place[1]) < half[1] + size[1] / 2 + room)
            return FALSE;
    }
    return TRUE;
}

/* The place nearest to the middle of the view where the block lies over no other, below before above before beside. */
static void find_room(TinkerCanvas *canvas, TinkerBlockId block, double place[2])
{
    TinkerScene *scene = tinker_document_scene(canvas->document);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    double middle[2], half[2] = {0, 0}, step = GRIDS_APART * tinker_scene_head(scene)->canvas_grid;
    canvas_to_world(canvas, canvas->view.width / 2, canvas->view.height / 3, middle);
    tinker_snap(canvas_grid(canvas, 0), &middle[0], &middle[1]);
    for (int k = 0; k < 2; k++) {
        int32_t column = tinker_block_class_meaning_column(block_class, TINKER_MEANING_WIDTH + k);
        if (column >= 0) half[k] = tinker_scene_get(scene, block, column) / 2;
    }
    static const int ways[][2] = {{0, -1}, {0, 1}, {1, 0}, {-1, 0}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}};
    for (int i = 0; i < MOST_PLACES; i++) {
        int ring = (i + 7) / 8;
        const int *way = ways[(i + 7) % 8];
        place[0] = middle[0] + ring * step * way[0];
        place[1] = middle[1] + ring * step * way[1];
        if (frame == NULL || is_free(frame, block, place, half)) return;
    }
}

/* Puts the ends onto the selected blocks, in the order they were selected. Answers how many found one. */
static int connect_to(TinkerCanvas *canvas, TinkerBlockId block, const TinkerBlockId *targets, int count)
{
    TinkerHistory *history = tinker_document_history(canvas->document);
    TinkerScene *scene = tinker_document_scene(canvas->document);
    int32_t ends = tinker_scene_end_count(scene, block), end = 0;
    if (count == 2 && tinker_is_joint(scene, block)) {
        end = tinker_joint_put_between(history, scene, block, targets);
        if (end == count) tinker_joined_bring(history, scene, targets[0]);
        return end;
    }
    if (count == 1 && tinker_is_joint(scene, block)) return tinker_joint_put_on(history, scene, block, targets[0]);
    for (int i = 0; i < count && end < ends; i++)
        if (tinker_history_set_end(history, block, end, (TinkerSceneEnd){targets[i], 0, 0}, NULL)) end++;
    return end;
}

/* The ends that stay free hang beside the block that the others are on; those of a joint lie where the other is. */
static void free_end_beside(TinkerCanvas *canvas, TinkerBlockId block, double place[2])
{
    TinkerScene *scene = tinker_document_scene(canvas->document);
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    TinkerSceneEnd first = tinker_scene_end(scene, block, 0);
    if (frame == NULL || first.block == TINKER_NO_BLOCK) return;
    if (tinker_is_joint(scene, block)) {
        tinker_frame_end(frame, first, place);
        return;
    }
    double orientation;
    tinker_frame_centre(frame, first.block, &place[0], &place[1], &orientation);
    place[1] += 2 * half_connector(canvas);
}

/* As many ends as there are selected blocks that ends can be on, where the type lets it: a rope goes over all of them.
 */
static int32_t wanted_ends(TinkerCanvas *canvas, const TinkerBlockType *type, const TinkerBlockId *targets, int count)
{
    int32_t bodies = 0;
    for (int i = 0; i < count; i++) {
        const TinkerBlockClass *of = tinker_scene_block_class(tinker_document_scene(canvas->document), targets[i]);
        if (of != NULL && of->physics != NULL && of->physics->body != NULL) bodies++;
    }
    if (type->most_ends >= 0) bodies = MIN(bodies, type->most_ends);
    return MAX(bodies, MAX(type->least_ends, 0));
}

TinkerBlockId tinker_canvas_add(TinkerCanvas *canvas, const TinkerBlockClass *block_class)
{
    int count;
    const TinkerBlockId *selection = tinker_document_selection(canvas->document, &count);
    g_autofree TinkerBlockId *targets = g_memdup2(selection, (gsize)count * sizeof(TinkerBlockId));
    if (tinker_player_time(canvas->player) > 0) tinker_player_rewind(canvas->player);
    g_autofree char *title = g_strdup_printf(_("Add %s"), tinker_translate(block_class->type->title));
    tinker_document_begin(canvas->document, title, NULL);
    TinkerBlockId block = tinker_history_add_block_of(tinker_document_history(canvas->document), block_class,
                                                      wanted_ends(canvas, block_class->type, targets, count));
    tinker_first_size(tinker_document_history(canvas->document), tinker_document_scene(canvas->document), block);
    double place[2];
    find_room(canvas, block, place);
    if (connect_to(canvas, block, targets, count) > 0) free_end_beside(canvas, block, place);
    tinker_document_place(canvas->document, block, place, half_apart(canvas, block));
    tinker_document_end(canvas->document);
    tinker_document_select(canvas->document, block);
    return block;
}
