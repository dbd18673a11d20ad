/* What stands for a block whose type nobody provides. */
#include "scene/store/scene-data.h"

ScenePlaceholder *scene_placeholder_copy(const ScenePlaceholder *placeholder)
{
    ScenePlaceholder *copy = g_new(ScenePlaceholder, 1);
    *copy = (ScenePlaceholder){g_strdup(placeholder->type), g_strdup(placeholder->text), g_strdup(placeholder->name),
                               placeholder->named};
    return copy;
}

void scene_placeholder_free(ScenePlaceholder *placeholder)
{
    g_free(placeholder->type);
    g_free(placeholder->text);
    g_free(placeholder->name);
    g_free(placeholder);
}
