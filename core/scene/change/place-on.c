/* Bodies that lie on a top. Their position and, where none is given, their orientation follow from the plate, as it is
 * at t = 0, motions applied; both are worked out into the columns after every change of the scene, so that whoever
 * reads a position need not know how it came about. */
#include "scene/frame/tops.h"
#include "scene/store/scene-data.h"

const ScenePlaceOn *scene_place_on(const TinkerScene *scene, TinkerBlockId block)
{
    return g_hash_table_lookup(scene->places_on, GINT_TO_POINTER(block));
}

void scene_set_place_on(TinkerScene *scene, TinkerBlockId block, const ScenePlaceOn *on)
{
    if (on == NULL)
        g_hash_table_remove(scene->places_on, GINT_TO_POINTER(block));
    else
        g_hash_table_replace(scene->places_on, GINT_TO_POINTER(block), g_memdup2(on, sizeof *on));
}

char *scene_place_on_fault(const TinkerScene *scene, TinkerBlockId block, TinkerBlockId plate)
{
    if (block == plate) return g_strdup("on names the block itself");
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, plate);
    if (block_class == NULL || tinker_class_has_top(block_class)) return NULL; /* nobody knows what a placeholder is */
    return g_strdup_printf("on names \"%s\", a %s, which has no top to lie on", tinker_scene_block_name(scene, plate),
                           block_class->type->id);
}

gboolean tinker_scene_lies_on(const TinkerScene *scene, TinkerBlockId block, TinkerBlockId *plate, double *along)
{
    const ScenePlaceOn *on = scene_place_on(scene, block);
    if (on == NULL) return FALSE;
    *plate = on->plate;
    *along = on->along;
    return TRUE;
}

GArray *scene_placed_on(const TinkerScene *scene, GHashTable *plates)
{
    GArray *bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (int32_t id = 0; g_hash_table_size(scene->places_on) > 0 && id < tinker_scene_id_limit(scene); id++) {
        const ScenePlaceOn *on = tinker_scene_has_block(scene, id) ? scene_place_on(scene, id) : NULL;
        if (on != NULL && g_hash_table_contains(plates, GINT_TO_POINTER(on->plate)) &&
            !g_hash_table_contains(plates, GINT_TO_POINTER(id)))
            g_array_append_val(bodies, id);
    }
    return bodies;
}

/* What a body is now becomes what was given. */
void scene_fix_place(TinkerScene *scene, TinkerBlockId block)
{
    SceneTable *table = scene_table_of(scene, block);
    const int32_t row = scene_slot(scene, block)->row;
    const int32_t position = table->block_class->meanings[TINKER_MEANING_POSITION];
    const int32_t orientation = table->block_class->meanings[TINKER_MEANING_ORIENTATION];
    table->given[position][row] = 1;
    if (orientation >= 0) {
        const double angle = table->columns[table->block_class->first_columns[orientation]][row];
        if (angle != table->block_class->properties[orientation].default_value[0]) table->given[orientation][row] = 1;
    }
    scene_set_place_on(scene, block, NULL);
}

/* Puts the body where it lies; a plate of a type that nobody provides has no top. */
static void put(TinkerScene *scene, const TinkerFrame *frame, TinkerBlockId block, const ScenePlaceOn *on)
{
    if (!tinker_class_has_top(tinker_scene_block_class(scene, on->plate))) return;
    SceneTable *table = scene_table_of(scene, block);
    const TinkerBlockClass *block_class = table->block_class;
    const int32_t row = scene_slot(scene, block)->row;
    const int32_t position = tinker_block_class_meaning_column(block_class, TINKER_MEANING_POSITION);
    const int32_t orientation = block_class->meanings[TINKER_MEANING_ORIENTATION];
    const TinkerTop top = tinker_top_of(frame, on->plate);
    const gboolean turned = orientation >= 0 && table->given[orientation][row];
    const double angle = turned ? table->columns[block_class->first_columns[orientation]][row] : top.angle;
    double centre[2];
    tinker_top_centre(&top, on->along, tinker_top_reach(frame, &top, block, angle), centre);
    for (int k = 0; k < 2; k++)
        table->columns[position + k][row] = centre[k];
    if (orientation >= 0 && !turned) table->columns[block_class->first_columns[orientation]][row] = top.angle;
    scene_table_resolve(table, row);
}

void scene_settle(TinkerScene *scene)
{
    if (g_hash_table_size(scene->places_on) == 0) return;
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    if (frame == NULL) return; /* a motion that fails at t = 0: nothing runs or is drawn before it is mended */
    GHashTableIter iter;
    gpointer key, value;
    g_hash_table_iter_init(&iter, scene->places_on);
    while (g_hash_table_iter_next(&iter, &key, &value)) {
        const TinkerBlockId block = GPOINTER_TO_INT(key);
        const ScenePlaceOn *on = value;
        if (tinker_scene_has_block(scene, block) && tinker_scene_has_block(scene, on->plate))
            put(scene, frame, block, on);
    }
}

void scene_settle_after(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    const TinkerPhysics *physics = block_class != NULL ? block_class->physics : NULL;
    const gboolean moves_tops = physics != NULL && physics->motion != NULL;
    if (moves_tops || tinker_class_has_top(block_class) || scene_place_on(scene, block) != NULL) scene_settle(scene);
}
