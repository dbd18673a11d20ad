/* Themes: what the colours of the SDK's meanings look like. */
#ifndef TINKER_CORE_THEME_H
#define TINKER_CORE_THEME_H

#include <glib.h>

#include <tinker/render.h>

typedef struct {
    const char *id; /* "light", "dark", "print", "contrast-light", "contrast-dark" */
    double background[4];
    double grid[4];
    double axis[4];
    double colours[TINKER_COLOUR_COUNT][4];
    double curves[8][4]; /* of graphs, in order; told apart also by those who do not see colours well */
} TinkerTheme;

/* NULL for an unknown id. Borrowed. */
const TinkerTheme *tinker_theme_find(const char *id);

/* All ids, ended by NULL. */
const char *const *tinker_theme_ids(void);

#endif
