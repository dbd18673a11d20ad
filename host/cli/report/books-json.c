#include "cli/report/books-json.h"

#include <stddef.h>

#include "cli/report/scene-json.h"

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
        const double *value = (const double *)(const void *)((const char *)&entry->all + member);
        if (pair)
            tinker_json_add_pair(list, name, value);
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
            sum[axis] += entry_at(books, i)->all.force[axis];
    cJSON_AddNumberToObject(newton, "time", books->to);
    add_entries(newton, "forces", books, scene, offsetof(TinkerBookShare, force), TRUE, FALSE);
    tinker_json_add_pair(newton, "sum", sum);
    tinker_json_add_pair(newton, "rate_of_momentum", books->rate);
    add_balance(newton, &books->newton);
}

static void add_momentum(cJSON *root, const TinkerBooks *books, TinkerScene *scene)
{
    cJSON *momentum = cJSON_AddObjectToObject(root, "momentum");
    cJSON *pairs = cJSON_AddArrayToObject(momentum, "momentum");
    for (int i = 0; i < 2; i++)
        cJSON_AddItemToArray(pairs, cJSON_CreateDoubleArray(books->momentum[i], 2));
    add_entries(momentum, "impulses", books, scene, offsetof(TinkerBookShare, impulse), TRUE, FALSE);
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
        tinker_json_add_pair(object, "impulse", impact->impulse);
        cJSON_AddNumberToObject(object, "work", impact->work);
        cJSON_AddItemToArray(list, object);
    }
}

/* The blocks between the bodies. */
static void add_cancelled(cJSON *root, const TinkerBooks *books, TinkerScene *scene)
{
    cJSON *list = cJSON_AddArrayToObject(root, "cancelled");
    for (guint i = 0; i < books->entries->len; i++)
        if (entry_at(books, i)->inner) tinker_json_add_cancelled(list, scene, entry_at(books, i)->by);
}

char *tinker_books_json(const TinkerBooks *books, TinkerScene *scene, const TinkerBlockId *bodies)
{
    cJSON *root = cJSON_CreateObject();
    cJSON_AddNumberToObject(root, "tinker_books", 1);
    cJSON_AddNumberToObject(root, "from", books->from);
    cJSON_AddNumberToObject(root, "to", books->to);
    cJSON *blocks = cJSON_AddArrayToObject(root, "blocks");
    for (; *bodies >= 0; bodies++)
        tinker_json_add_name(blocks, scene, *bodies);
    add_newton(root, books, scene);
    cJSON *energy = cJSON_AddObjectToObject(root, "energy");
    tinker_json_add_pair(energy, "kinetic", books->kinetic);
    add_entries(energy, "work", books, scene, offsetof(TinkerBookShare, work), FALSE, TRUE);
    add_balance(energy, &books->energy);
    add_momentum(root, books, scene);
    cJSON *angular = cJSON_AddObjectToObject(root, "angular");
    tinker_json_add_pair(angular, "about", books->about);
    tinker_json_add_pair(angular, "angular_momentum", books->angular);
    add_entries(angular, "impulses", books, scene, offsetof(TinkerBookShare, angular), FALSE, FALSE);
    add_balance(angular, &books->moment);
    cJSON_AddNumberToObject(root, "unsettled", books->unsettled);
    add_impacts(root, books, scene);
    add_cancelled(root, books, scene);
    char *text = cJSON_Print(root), *copy = g_strdup(text);
    cJSON_free(text);
    cJSON_Delete(root);
    return copy;
}
