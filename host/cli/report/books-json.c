#include "cli/report/books-json.h"

#include <cjson/cJSON.h>
#include <stddef.h>

static void add_pair(cJSON *object, const char *key, const double pair[2])
{
    cJSON_AddItemToObject(object, key, cJSON_CreateDoubleArray(pair, 2));
}

static const TinkerBookEntry *entry_at(const TinkerBooks *books, guint number)
{
    return &g_array_index(books->entries, TinkerBookEntry, number);
}

/* One member of every entry by its block's name; a pair, or one number. */
static void add_entries(cJSON *object, const char *key, const TinkerBooks *books, TinkerScene *scene, gsize member,
                        gboolean pair, gboolean inner)
{
    cJSON *list = cJSON_AddObjectToObject(object, key);
    for (guint i = 0; i < books->entries->len; i++) {
        const TinkerBookEntry *entry = entry_at(books, i);
        if (entry->inner && !inner) continue;
        const char *name = tinker_scene_block_name(scene, entry->by);
        const double *value = (const double *)(const void *)((const char *)entry + member);
        if (pair)
            add_pair(list, name, value);
        else
            cJSON_AddNumberToObject(list, name, value[0]);
    }
}

static void add_balance(cJSON *object, const TinkerBookBalance *balance)
{
    cJSON_AddNumberToObject(object, "residual", balance->residual);
    cJSON_AddNumberToObject(object, "scale", balance->scale);
}

static void add_newton(cJSON *root, const TinkerBooks *books, TinkerScene *scene)
{
    cJSON *newton = cJSON_AddObjectToObject(root, "newton");
    double sum[2] = {0, 0};
    for (guint i = 0; i < books->entries->len; i++)
        for (int axis = 0; axis < 2 && !entry_at(books, i)->inner; axis++)
            sum[axis] += entry_at(books, i)->force[axis];
    cJSON_AddNumberToObject(newton, "time", books->to);
    add_entries(newton, "forces", books, scene, offsetof(TinkerBookEntry, force), TRUE, FALSE);
    add_pair(newton, "sum", sum);
    add_pair(newton, "rate_of_momentum", books->rate);
    add_balance(newton, &books->newton);
}

static void add_momentum(cJSON *root, const TinkerBooks *books, TinkerScene *scene)
{
    cJSON *momentum = cJSON_AddObjectToObject(root, "momentum");
    cJSON *pairs = cJSON_AddArrayToObject(momentum, "momentum");
    for (int i = 0; i < 2; i++)
        cJSON_AddItemToArray(pairs, cJSON_CreateDoubleArray(books->momentum[i], 2));
    add_entries(momentum, "impulses", books, scene, offsetof(TinkerBookEntry, impulse), TRUE, FALSE);
    add_balance(momentum, &books->impulse);
}

static void add_impacts(cJSON *root, const TinkerBooks *books, TinkerScene *scene)
{
    cJSON *list = cJSON_AddArrayToObject(root, "impacts");
    for (guint i = 0; i < books->impacts->len; i++) {
        const TinkerBookImpact *impact = &g_array_index(books->impacts, TinkerBookImpact, i);
        cJSON *object = cJSON_CreateObject();
        cJSON_AddNumberToObject(object, "time", impact->time);
        cJSON_AddStringToObject(object, "block", tinker_scene_block_name(scene, impact->on));
        if (impact->by >= 0)
            cJSON_AddStringToObject(object, "by", tinker_scene_block_name(scene, impact->by));
        else
            cJSON_AddNullToObject(object, "by");
        add_pair(object, "impulse", impact->impulse);
        cJSON_AddNumberToObject(object, "work", impact->work);
        cJSON_AddItemToArray(list, object);
    }
}

/* The blocks between the bodies, with their ends. */
static void add_cancelled(cJSON *root, const TinkerBooks *books, TinkerScene *scene)
{
    cJSON *list = cJSON_AddArrayToObject(root, "cancelled");
    for (guint i = 0; i < books->entries->len; i++) {
        const TinkerBlockId by = entry_at(books, i)->by;
        if (!entry_at(books, i)->inner) continue;
        cJSON *object = cJSON_CreateObject();
        cJSON_AddStringToObject(object, "block", tinker_scene_block_name(scene, by));
        cJSON *on = cJSON_AddArrayToObject(object, "on");
        for (int32_t k = 0; k < tinker_scene_end_count(scene, by); k++)
            cJSON_AddItemToArray(
                on, cJSON_CreateString(tinker_scene_block_name(scene, tinker_scene_end(scene, by, k).block)));
        cJSON_AddItemToArray(list, object);
    }
}

char *tinker_books_json(const TinkerBooks *books, TinkerScene *scene, const TinkerBlockId *bodies)
{
    cJSON *root = cJSON_CreateObject();
    cJSON_AddNumberToObject(root, "tinker_books", 1);
    cJSON_AddNumberToObject(root, "from", books->from);
    cJSON_AddNumberToObject(root, "to", books->to);
    cJSON *blocks = cJSON_AddArrayToObject(root, "blocks");
    for (; *bodies >= 0; bodies++)
        cJSON_AddItemToArray(blocks, cJSON_CreateString(tinker_scene_block_name(scene, *bodies)));
    add_newton(root, books, scene);
    cJSON *energy = cJSON_AddObjectToObject(root, "energy");
    add_pair(energy, "kinetic", books->kinetic);
    add_entries(energy, "work", books, scene, offsetof(TinkerBookEntry, work), FALSE, TRUE);
    add_balance(energy, &books->energy);
    add_momentum(root, books, scene);
    cJSON *angular = cJSON_AddObjectToObject(root, "angular");
    add_pair(angular, "about", books->about);
    add_pair(angular, "angular_momentum", books->angular);
    add_entries(angular, "impulses", books, scene, offsetof(TinkerBookEntry, angular), FALSE, FALSE);
    add_balance(angular, &books->moment);
    add_impacts(root, books, scene);
    add_cancelled(root, books, scene);
    char *text = cJSON_Print(root), *copy = g_strdup(text);
    cJSON_free(text);
    cJSON_Delete(root);
    return copy;
}
