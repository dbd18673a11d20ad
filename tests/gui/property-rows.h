/* Rows of a property list by what they are called, for both fixtures of the panel. */
#ifndef TEST_PROPERTY_ROWS_H
#define TEST_PROPERTY_ROWS_H

#include "gui/property/property-list.h"

/* NULL where there is none. (transfer full) */
static inline TinkerPropertyRow *property_rows_find(TinkerDocument *document, TinkerPlayer *player, gboolean trims,
                                                    const char *group, const char *title)
{
    g_autoptr(GPtrArray) rows = tinker_property_list_new(document, player, trims);
    for (guint i = 0; i < rows->len; i++) {
        TinkerPropertyRow *row = g_ptr_array_index(rows, i);
        if (g_str_equal(row->group, group) && g_str_equal(row->title, title)) return tinker_property_row_ref(row);
    }
    return NULL;
}

/* The number of the choice with this text, which there must be. */
static inline int property_rows_choice(const TinkerPropertyRow *row, const char *text)
{
    int choice = 0;
    while (row->choices[choice] != NULL && !g_str_equal(row->choices[choice], text))
        choice++;
    g_assert_nonnull(row->choices[choice]);
    return choice;
}

#endif
