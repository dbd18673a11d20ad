/* What reports say in JSON of blocks of a scene, each by its name. */
#ifndef TINKER_CLI_SCENE_JSON_H
#define TINKER_CLI_SCENE_JSON_H

#include <cjson/cJSON.h>

#include "scene/store/scene.h"

/* Appends the name of a block to a list. */
void tinker_json_add_name(cJSON *list, TinkerScene *scene, TinkerBlockId block);

/* The names of blocks (of TinkerBlockId) as a list under the key. */
void tinker_json_add_names(cJSON *object, TinkerScene *scene, const GArray *blocks);

/* Appends a block that acts between bodies, with what stands at its ends: forces that cancel. */
void tinker_json_add_cancelled(cJSON *list, TinkerScene *scene, TinkerBlockId block);

/* x and y. */
void tinker_json_add_pair(cJSON *object, const char *key, const double pair[2]);

#endif
