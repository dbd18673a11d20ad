/* What lies under the pointer. */
#include "gui/canvas/canvas-private.h"

/* An end that is attached lies over the body it is on: that is meant, unless the connector is selected. What has its
 * ends at one place, as a pin, is meant itself, for nothing else of it could be clicked. */
static TinkerHit body_rather_than_end(TinkerCanvas *canvas, TinkerFrame *frame, TinkerHit hit, const double world[2])
{
    TinkerScene *scene = tinker_frame_scene(frame);
    gboolean is_end = hit.part >= 0 && hit.part < tinker_scene_end_count(scene, hit.block);
    if (!is_end || tinker_document_is_selected(canvas->document, hit.block)) return hit;
    if (tinker_is_at_one_place(frame, hit.block)) return (TinkerHit){hit.block, TINKER_PART_WHOLE};
    TinkerBlockId body = tinker_scene_end(scene, hit.block, hit.part).block;
    if (body == TINKER_NO_BLOCK) return hit;
    TinkerBlockId under = tinker_hit_connectable(frame, hit.block, world[0], world[1], 0);
    return under == body ? (TinkerHit){body, TINKER_PART_WHOLE} : hit;
}

gboolean canvas_acts_at_once(TinkerCanvas *canvas, TinkerHit hit)
{
    const TinkerScene *scene = tinker_document_scene(canvas->document);
    if (tinker_player_state(canvas->player) != TINKER_PLAYER_PLAYING || hit.block == TINKER_NO_BLOCK) return FALSE;
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, hit.block);
    return hit.part >= TINKER_PART_HANDLE && block_class != NULL && block_class->physics != NULL &&
           block_class->physics->force_element != NULL;
}

TinkerHit canvas_hit_at(TinkerCanvas *canvas, double x, double y, gboolean handles)
{
    TinkerFrame *frame = tinker_player_frame(canvas->player);
    TinkerHit hit = {TINKER_NO_BLOCK, TINKER_PART_NONE};
    if (frame == NULL) return hit;
    double world[2];
    canvas_to_world(canvas, x, y, world);
    tinker_frame_set_symbol_size(frame,
                                 tinker_painter_symbol_size(frame, canvas->view.scale / canvas_magnification(canvas)));
    TinkerBlockId selected = tinker_document_selected(canvas->document);
    if (handles && selected != TINKER_NO_BLOCK)
        hit = tinker_hit_handle(frame, selected, world[0], world[1], canvas_reach(canvas));
    if (tinker_frame_time(frame) != 0 && !canvas_acts_at_once(canvas, hit)) hit.block = TINKER_NO_BLOCK;
    if (hit.block == TINKER_NO_BLOCK) hit = tinker_hit(frame, world[0], world[1], canvas_reach(canvas));
    if (hit.block != TINKER_NO_BLOCK) return body_rather_than_end(canvas, frame, hit, world);
    return (TinkerHit){tinker_painter_field_at(frame, &canvas->view, x, y), TINKER_PART_NONE};
}

TinkerHit tinker_canvas_handle(TinkerCanvas *canvas, double place[2])
{
    TinkerFrame *frame = tinker_player_frame(canvas->player);
    const TinkerBlockId selected = tinker_document_selected(canvas->document);
    canvas_to_world(canvas, canvas->pointer[0], canvas->pointer[1], place);
    if (frame == NULL || selected == TINKER_NO_BLOCK) return (TinkerHit){TINKER_NO_BLOCK, TINKER_PART_NONE};
    return tinker_hit_handle(frame, selected, place[0], place[1], canvas_reach(canvas));
}
