/* Ends are kept as those of connectors are, so that what is measured goes along with the bodies. */
#include "gui/instrument/measuring.h"

#include <glib/gi18n.h>
#include <math.h>

#include "edit/drag.h"
#include "scene/history/history.h"

/* The blocks that stay, and the order in which they have the ends. */
static const struct {
    const char *type, *title;
    int ends[3];
} kept[] = {[TINKER_RULER] = {"dimension", N_("Keep as Dimension"), {0, 1}},
            [TINKER_PROTRACTOR] = {"angle-mark", N_("Keep as Angle Mark"), {1, 0, 2}}};

int tinker_measuring_whole(TinkerMeasuringKind kind)
{
    return kind == TINKER_RULER ? 2 : 3;
}

/* The points of one block. A body that does not turn has its centre alone. */
static void add_points(GArray *points, TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    if (block_class == NULL) return;
    for (int32_t i = 0; i < tinker_scene_end_count(scene, block); i++) {
        const TinkerSceneEnd end = tinker_scene_end(scene, block, i);
        if (end.block != TINKER_NO_BLOCK) g_array_append_val(points, end);
    }
    if (block_class->physics == NULL || block_class->physics->body == NULL) return;
    const TinkerSceneEnd centre = {block, 0, 0};
    g_array_append_val(points, centre);
    const int32_t width = tinker_block_class_meaning_column(block_class, TINKER_MEANING_WIDTH);
    const int32_t height = tinker_block_class_meaning_column(block_class, TINKER_MEANING_HEIGHT);
    const int freedoms = block_class->physics->body->degrees_of_freedom;
    if (width < 0 || height < 0 || freedoms == 2) return;
    for (int corner = 0; corner < 4; corner++) {
        const double across = corner % 2 == 0 ? -0.5 : 0.5, up = corner < 2 ? -0.5 : 0.5;
        const TinkerSceneEnd end = {block, across * tinker_scene_get(scene, block, width),
                                    up * tinker_scene_get(scene, block, height)};
        g_array_append_val(points, end);
    }
}

GArray *tinker_measuring_points(TinkerScene *scene)
{
    GArray *points = g_array_new(FALSE, FALSE, sizeof(TinkerSceneEnd));
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++)
        add_points(points, scene, tinker_scene_block_at(scene, place));
    return points;
}

TinkerSceneEnd tinker_measuring_snap(const TinkerFrame *frame, double x, double y, double reach, double grid)
{
    g_autoptr(GArray) points = tinker_measuring_points(tinker_frame_scene(frame));
    TinkerSceneEnd nearest = {TINKER_NO_BLOCK, x, y};
    double least = reach;
    for (guint i = 0; i < points->len; i++) {
        const TinkerSceneEnd end = g_array_index(points, TinkerSceneEnd, i);
        double place[2];
        tinker_frame_end(frame, end, place);
        const double away = hypot(place[0] - x, place[1] - y);
        if (!(away < least)) continue;
        least = away;
        nearest = end;
    }
    if (nearest.block == TINKER_NO_BLOCK) tinker_snap(grid, &nearest.x, &nearest.y);
    return nearest;
}

static char *angle_text(double angle)
{
    return g_strdup_printf("%.2f°", angle * 180 / G_PI);
}

static char *distance_text(const double a[2], const double b[2], TinkerUnitSystem system, gboolean in_full)
{
    static const TinkerDimension length = TINKER_DIMENSION_LENGTH;
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    g_autofree char *whole = tinker_quantity_format(hypot(dx, dy), length, NULL, system, 3);
    if (!in_full) return g_steal_pointer(&whole);
    g_autofree char *across = tinker_quantity_format(dx, length, NULL, system, 3);
    g_autofree char *up = tinker_quantity_format(dy, length, NULL, system, 3);
    g_autofree char *angle = angle_text(dx == 0 && dy == 0 ? 0 : atan2(dy, dx));
    return g_strdup_printf("%s, Δx = %s, Δy = %s, %s", whole, across, up, angle);
}

char *tinker_measuring_text(const TinkerMeasuring *measuring, const TinkerFrame *frame, gboolean in_full)
{
    double at[3][2];
    if (measuring->count < tinker_measuring_whole(measuring->kind)) return NULL;
    for (int i = 0; i < measuring->count; i++)
        tinker_frame_end(frame, measuring->ends[i], at[i]);
    if (measuring->kind == TINKER_RULER)
        return distance_text(at[0], at[1], tinker_scene_head(tinker_frame_scene(frame))->units, in_full);
    const double a[2] = {at[1][0] - at[0][0], at[1][1] - at[0][1]}, b[2] = {at[2][0] - at[0][0], at[2][1] - at[0][1]};
    return angle_text(atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]));
}

const char *tinker_measuring_why_not_kept(const TinkerMeasuring *measuring, TinkerScene *scene)
{
    static const char *const off[][3] = {
        [TINKER_RULER] = {N_("Its first end is not on a body or support, where both ends of a block have to be"),
                          N_("Its second end is not on a body or support, where both ends of a block have to be")},
        [TINKER_PROTRACTOR] = {
            N_("Its corner is not on a body or support, where all places of a block have to be"),
            N_("Its first leg does not end on a body or support, where all places of a block have to be"),
            N_("Its second leg does not end on a body or support, where all places of a block have to be")}};
    if (measuring->count < tinker_measuring_whole(measuring->kind)) return _("Nothing is measured yet");
    for (int i = 0; i < measuring->count; i++)
        if (measuring->ends[i].block == TINKER_NO_BLOCK || !tinker_scene_has_block(scene, measuring->ends[i].block))
            return _(off[measuring->kind][i]);
    return NULL;
}

gboolean tinker_measuring_keep(const TinkerMeasuring *measuring, TinkerDocument *document, GError **error)
{
    TinkerScene *scene = tinker_document_scene(document);
    TinkerHistory *history = tinker_document_history(document);
    const int whole = tinker_measuring_whole(measuring->kind);
    const TinkerBlockClass *block_class =
        tinker_catalogue_type(tinker_document_catalogue(document), kept[measuring->kind].type, error);
    if (block_class == NULL || tinker_measuring_why_not_kept(measuring, scene) != NULL) return FALSE;
    tinker_document_begin(document, _(kept[measuring->kind].title), NULL);
    const TinkerBlockId block = tinker_history_add_block_of(history, block_class, whole);
    for (int i = 0; i < whole; i++)
        if (!tinker_history_set_end(history, block, i, measuring->ends[kept[measuring->kind].ends[i]], error)) {
            tinker_document_abort(document);
            return FALSE;
        }
    tinker_document_end(document);
    tinker_document_select(document, block);
    return TRUE;
}
