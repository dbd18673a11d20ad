/* The head of a scene, and its graphs: copying them, and what they may hold. */
#include <math.h>
#include <string.h>

#include "scene/value/reader.h"

const char *const scene_contacts[] = {"events", "impulse", NULL};
const char *const tinker_scene_impact_laws[] = {"newton", "poisson", "sequential", NULL};

#define POSITIVE       TINKER_HAS_MINIMUM | TINKER_OPEN_MINIMUM
#define OFFSET(member) G_STRUCT_OFFSET(TinkerSceneHead, member)
const SceneHeadNumber scene_head_numbers[] = {
    {"canvas", {.id = "width", .dimension = {.length = 1}, .flags = POSITIVE}, OFFSET(canvas_width)},
    {"canvas", {.id = "grid", .dimension = {.length = 1}, .flags = POSITIVE}, OFFSET(canvas_grid)},
    {"run", {.id = "duration", .dimension = {.time = 1}, .flags = POSITIVE}, OFFSET(run.duration)},
    {"run", {.id = "interval", .dimension = {.time = 1}, .flags = POSITIVE}, OFFSET(run.interval)},
    {"run", {.id = "step", .dimension = {.time = 1}, .flags = POSITIVE}, OFFSET(run.step)},
    {"run",
     {.id = "tolerance", .flags = POSITIVE | TINKER_HAS_MAXIMUM | TINKER_OPEN_MAXIMUM, .hard_maximum = 1},
     OFFSET(run.tolerance)},
    {"run",
     {.id = "accuracy", .flags = POSITIVE | TINKER_HAS_MAXIMUM | TINKER_OPEN_MAXIMUM, .hard_maximum = 1},
     OFFSET(run.accuracy),
     .may_be_none = TRUE},
    {"run",
     {.id = "spectral_radius", .flags = TINKER_HAS_MINIMUM | TINKER_HAS_MAXIMUM, .hard_maximum = 1},
     OFFSET(run.spectral_radius)},
    {NULL},
};

/* Head --------------------------------------------------------------------------------------------------------- */

void scene_head_init(TinkerSceneHead *head)
{
    *head = (TinkerSceneHead){
        .title = g_strdup(""),
        .description = g_strdup(""),
        .author = g_strdup(""),
        .units = TINKER_UNIT_SYSTEM_SI,
        .canvas_width = 10,
        .canvas_grid = 0.2,
        .canvas_snap = TRUE,
        .run = {.duration = 10,
                .interval = 0.01,
                .method = g_strdup("auto"),
                .step = 0.01,
                .tolerance = 1e-9,
                .contacts = g_strdup("events"),
                .impact_law = g_strdup("newton"),
                .spectral_radius = 0.8,
                .until = g_strdup("")},
    };
}

void scene_head_clear(TinkerSceneHead *head)
{
    g_free(head->title);
    g_free(head->description);
    g_free(head->author);
    g_free(head->run.method);
    g_free(head->run.contacts);
    g_free(head->run.until);
    g_free(head->run.impact_law);
}

TinkerSceneHead *scene_head_copy(const TinkerSceneHead *head)
{
    TinkerSceneHead *copy = g_new(TinkerSceneHead, 1);
    *copy = *head;
    copy->title = g_strdup(head->title);
    copy->description = g_strdup(head->description);
    copy->author = g_strdup(head->author);
    copy->run.method = g_strdup(head->run.method);
    copy->run.contacts = g_strdup(head->run.contacts);
    copy->run.until = g_strdup(head->run.until);
    copy->run.impact_law = g_strdup(head->run.impact_law);
    return copy;
}

void scene_head_free(TinkerSceneHead *head)
{
    scene_head_clear(head);
    g_free(head);
}

char *scene_head_fault(const TinkerSceneHead *head)
{
    const struct {
        const char *what, *text;
    } texts[] = {{"title", head->title},
                 {"description", head->description},
                 {"author", head->author},
                 {"run: method", head->run.method},
                 {"run: contacts", head->run.contacts},
                 {"run: until", head->run.until},
                 {"run: impact_law", head->run.impact_law}};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        if (texts[i].text == NULL || !g_utf8_validate(texts[i].text, -1, NULL))
            return g_strdup_printf("%s must be UTF-8 text", texts[i].what);
    if (!g_strv_contains(scene_contacts, head->run.contacts))
        return g_strdup_printf("run: contacts must be \"events\" or \"impulse\" (it is \"%s\")", head->run.contacts);
    if (!g_strv_contains(tinker_scene_impact_laws, head->run.impact_law))
        return g_strdup_printf("run: impact_law must be \"newton\", \"poisson\" or \"sequential\" (it is \"%s\")",
                               head->run.impact_law);
    if (head->units != TINKER_UNIT_SYSTEM_SI && head->units != TINKER_UNIT_SYSTEM_ENGLISH)
        return g_strdup("units must be SI or English");
    for (const SceneHeadNumber *number = scene_head_numbers; number->part != NULL; number++) {
        double value;
        memcpy(&value, G_STRUCT_MEMBER_P(head, number->offset), sizeof value);
        if (number->may_be_none && value == 0) continue;
        g_autofree char *fault = scene_value_fault(&number->type, &value, NULL);
        if (fault != NULL) return g_strdup_printf("%s: %s", number->part, fault);
    }
    return NULL;
}
