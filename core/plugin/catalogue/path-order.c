/* The order of paths, the same on every machine. */
#include <string.h>

#include "plugin/catalogue/search.h"

static int compare_paths(gconstpointer a, gconstpointer b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

void tinker_search_sort(GPtrArray *paths)
{
    g_ptr_array_sort(paths, compare_paths);
}
