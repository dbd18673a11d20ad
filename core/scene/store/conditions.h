/* Conditions that end a run, as text: "{Mass 0.y} = 0; event(impact, Mass 0)". What they mean: measure/until.h. */
#ifndef TINKER_CORE_SCENE_CONDITIONS_H
#define TINKER_CORE_SCENE_CONDITIONS_H

#include <glib.h>

/* The conditions of a text, which semicolons separate that stand neither in braces nor in parentheses; without space
 * around them, and without those that are empty. (transfer full) */
char **tinker_conditions_split(const char *text);

/* The text once the block called `from` is called `to`; NULL where it does not name it. (transfer full) */
char *tinker_conditions_renamed(const char *text, const char *from, const char *to);

/* The block that "event(KIND, BLOCK)" names, NULL where it names none, and its kind; NULL too where the condition is no
 * event at all. Where the last parenthesis is missing the name is what there is of it. (transfer full) */
char *tinker_condition_event(const char *condition, char **block);

#endif
