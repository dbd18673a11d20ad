/* After every edit that is over, what lay on tops before is compared with what lies on them now. */
#include "gui/start/left-behind.h"

#include <math.h>

#include "scene/frame/tops.h"

#define MOST_PAIRS 20000 /* bodies times tops: beyond, looking at all of them would be felt */

struct _TinkerLeftBehind {
    GObject parent_instance;
    TinkerDocument *document;
    GArray *lay;  /* of TinkerLying: before the edit */
    GArray *left; /* of TinkerLying */
};

G_DEFINE_FINAL_TYPE(TinkerLeftBehind, tinker_left_behind, G_TYPE_OBJECT)

static guint changed_signal;

static const TinkerLying *lying_at(const GArray *array, guint number)
{
    return &g_array_index(array, TinkerLying, number);
}

static gboolean is_too_large(const TinkerScene *scene)
{
    gint64 bodies = 0, plates = 0;
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, tinker_scene_block_at(scene, i));
        if (block_class == NULL) continue;
        bodies += tinker_class_can_lie(block_class);
        plates += tinker_class_has_top(block_class);
    }
    return bodies * plates > MOST_PAIRS;
}

/* The body with the solid top that is nearest to it. FALSE for what can lie on none. */
static gboolean look_at(const TinkerFrame *frame, TinkerBlockId body, TinkerTop *top, TinkerLying *lying)
{
    double gap, orientation;
    if (!tinker_class_can_lie(tinker_scene_block_class(tinker_frame_scene(frame), body))) return FALSE;
    *top = tinker_top_nearest(frame, body);
    if (top->plate == TINKER_NO_BLOCK) return FALSE;
    *lying = (TinkerLying){.body = body, .plate = top->plate};
    tinker_top_foot(frame, top, body, &lying->along, &gap);
    tinker_frame_centre(frame, body, &lying->place[0], &lying->place[1], &orientation);
    return TRUE;
}

/* What lies on tops now. (transfer full) */
static GArray *lying_now(TinkerScene *scene)
{
    GArray *lie = g_array_new(FALSE, FALSE, sizeof(TinkerLying));
    g_autoptr(TinkerFrame) frame = is_too_large(scene) ? NULL : tinker_frame_new(scene, NULL);
    for (int32_t i = 0; frame != NULL && i < tinker_scene_block_count(scene); i++) {
        TinkerTop top;
        TinkerLying lying;
        if (look_at(frame, tinker_scene_block_at(scene, i), &top, &lying) &&
            tinker_top_touches(frame, &top, lying.body))
            g_array_append_val(lie, lying);
    }
    return lie;
}

/* Whether it is where it was, and neither on its top nor sunk into it, nor on another one. */
static gboolean hangs(TinkerScene *scene, const TinkerLying *lay)
{
    if (!tinker_scene_has_block(scene, lay->body) || !tinker_scene_has_block(scene, lay->plate)) return FALSE;
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    TinkerLying now;
    TinkerTop nearest;
    double along, gap;
    if (frame == NULL || !look_at(frame, lay->body, &nearest, &now)) return FALSE;
    if (now.place[0] != lay->place[0] || now.place[1] != lay->place[1]) return FALSE;
    const TinkerTop top = tinker_top_of(frame, lay->plate);
    tinker_top_foot(frame, &top, lay->body, &along, &gap);
    return !tinker_top_touches(frame, &nearest, lay->body) && (gap > 0 || fabs(along) > top.half_width);
}

static gboolean is_listed(const GArray *array, TinkerBlockId body)
{
    for (guint i = 0; i < array->len; i++)
        if (lying_at(array, i)->body == body) return TRUE;
    return FALSE;
}

static void on_changed(TinkerLeftBehind *self)
{
    TinkerScene *scene = tinker_document_scene(self->document);
    if (tinker_history_is_open(tinker_document_history(self->document))) return; /* who knows where a drag ends */
    const guint before = self->left->len;
    guint dropped = 0;
    for (guint i = self->left->len; i-- > 0;)
        if (!hangs(scene, lying_at(self->left, i))) {
            g_array_remove_index(self->left, i);
            dropped++;
        }
    GArray *lie = lying_now(scene);
    for (guint i = 0; i < self->lay->len; i++) {
        const TinkerLying *lay = lying_at(self->lay, i);
        if (!is_listed(lie, lay->body) && !is_listed(self->left, lay->body) && hangs(scene, lay))
            g_array_append_val(self->left, *lay);
    }
    g_array_unref(self->lay);
    self->lay = lie;
    if (dropped > 0 || self->left->len != before - dropped) g_signal_emit(self, changed_signal, 0);
}

static void on_replaced(TinkerLeftBehind *self)
{
    g_array_set_size(self->lay, 0);
    g_array_set_size(self->left, 0);
    g_signal_emit(self, changed_signal, 0);
}

const GArray *tinker_left_behind_bodies(TinkerLeftBehind *left)
{
    return left->left;
}

gboolean tinker_left_behind_lay(TinkerDocument *document, const TinkerLying *lying, GError **error)
{
    TinkerScene *scene = tinker_document_scene(document);
    tinker_document_interrupt(document);
    if (!tinker_scene_has_block(scene, lying->body) || !tinker_scene_has_block(scene, lying->plate)) return TRUE;
    TinkerFrame *frame = tinker_frame_new(scene, error);
    if (frame == NULL) return FALSE;
    const TinkerTop top = tinker_top_of(frame, lying->plate);
    tinker_frame_free(frame);
    if (!tinker_history_lay_on(tinker_document_history(document), lying->body, lying->plate,
                               tinker_top_round(&top, lying->along), error))
        return FALSE;
    tinker_document_touch(document);
    return TRUE;
}

static void tinker_left_behind_finalize(GObject *object)
{
    TinkerLeftBehind *self = TINKER_LEFT_BEHIND(object);
    g_array_unref(self->lay);
    g_array_unref(self->left);
    g_object_unref(self->document);
    G_OBJECT_CLASS(tinker_left_behind_parent_class)->finalize(object);
}

static void tinker_left_behind_class_init(TinkerLeftBehindClass *class)
{
    G_OBJECT_CLASS(class)->finalize = tinker_left_behind_finalize;
    changed_signal =
        g_signal_new("changed", TINKER_TYPE_LEFT_BEHIND, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void tinker_left_behind_init(TinkerLeftBehind *self)
{
    self->lay = g_array_new(FALSE, FALSE, sizeof(TinkerLying));
    self->left = g_array_new(FALSE, FALSE, sizeof(TinkerLying));
}

TinkerLeftBehind *tinker_left_behind_new(TinkerDocument *document)
{
    TinkerLeftBehind *self = g_object_new(TINKER_TYPE_LEFT_BEHIND, NULL);
    self->document = g_object_ref(document);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), self, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "replaced", G_CALLBACK(on_replaced), self, G_CONNECT_SWAPPED);
    on_changed(self);
    return self;
}
