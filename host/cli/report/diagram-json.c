/* A diagram as JSON. */
#include <math.h>

#include "cli/report/diagram-report.h"
#include "cli/report/scene-json.h"

static void add_force(cJSON *list, const TinkerDiagramForce *force, TinkerScene *scene)
{
    cJSON *object = cJSON_CreateObject();
    cJSON_AddStringToObject(object, "from", tinker_scene_block_name(scene, force->from));
    cJSON_AddStringToObject(object, "kind", tinker_term_kind_name(force->kind));
    tinker_json_add_pair(object, "point", force->point);
    tinker_json_add_pair(object, "force", force->force);
    cJSON_AddNumberToObject(object, "torque", force->torque);
    if (force->second >= 0) {
        cJSON *both = cJSON_AddArrayToObject(object, "partner");
        tinker_json_add_name(both, scene, force->partner);
        tinker_json_add_name(both, scene, force->second);
    } else if (force->partner >= 0)
        cJSON_AddStringToObject(object, "partner", tinker_scene_block_name(scene, force->partner));
    else
        cJSON_AddNullToObject(object, "partner");
    cJSON_AddItemToArray(list, object);
}

static void add_blocks(cJSON *root, TinkerScene *scene, const TinkerBlockId *blocks)
{
    if (blocks[1] < 0) {
        cJSON_AddStringToObject(root, "block", tinker_scene_block_name(scene, blocks[0]));
        return;
    }
    cJSON *names = cJSON_AddArrayToObject(root, "blocks");
    for (; *blocks >= 0; blocks++)
        tinker_json_add_name(names, scene, *blocks);
}

static void add_cancelled(cJSON *root, const TinkerDiagram *diagram, TinkerScene *scene)
{
    cJSON *list = cJSON_AddArrayToObject(root, "cancelled");
    for (guint i = 0; i < diagram->cancelled->len; i++)
        tinker_json_add_cancelled(list, scene, g_array_index(diagram->cancelled, TinkerBlockId, i));
}

char *tinker_diagram_json(const TinkerDiagram *diagram, TinkerScene *scene, const TinkerBlockId *blocks)
{
    cJSON *root = cJSON_CreateObject();
    cJSON_AddNumberToObject(root, "tinker_diagram", 1);
    cJSON_AddNumberToObject(root, "time", diagram->time);
    add_blocks(root, scene, blocks);
    if (diagram->moves)
        cJSON_AddNumberToObject(root, "mass", diagram->mass);
    else
        cJSON_AddNullToObject(root, "mass");
    if (isnan(diagram->inertia))
        cJSON_AddNullToObject(root, "inertia");
    else
        cJSON_AddNumberToObject(root, "inertia", diagram->inertia);
    tinker_json_add_pair(root, "centre", diagram->centre);
    cJSON *forces = cJSON_AddArrayToObject(root, "forces");
    for (guint i = 0; i < diagram->forces->len; i++)
        add_force(forces, &g_array_index(diagram->forces, TinkerDiagramForce, i), scene);
    if (blocks[1] >= 0) add_cancelled(root, diagram, scene);
    if (diagram->moves) {
        cJSON *kinetic = cJSON_AddObjectToObject(root, "kinetic");
        tinker_json_add_pair(kinetic, "force", diagram->kinetic);
        cJSON_AddNumberToObject(kinetic, "torque", diagram->turning);
    }
    char *text = cJSON_Print(root), *copy = g_strdup(text);
    cJSON_free(text);
    cJSON_Delete(root);
    return copy;
}
