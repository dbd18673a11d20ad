/* A text of points, split at semicolons, each of two numbers. */
#include "units/quantity/point-text.h"

#include <math.h>
#include <string.h>

#include "units/quantity/units.h"

static gboolean refuse(int number, const char *text, const char *why, GError **error)
{
    g_set_error(error, TINKER_UNITS_ERROR, TINKER_UNITS_ERROR_SYNTAX,
                "point %d, \"%s\": %s (points are written as \"x y; x y; ...\")", number, text, why);
    return FALSE;
}

/* "x, y", each with a unit or none; or two plain numbers. */
static gboolean parse_point(const char *text, int number, TinkerDimension dimension, GArray *points, GError **error)
{
    g_auto(GStrv) parts = g_strsplit_set(text, strchr(text, ',') != NULL ? "," : " \t\n", -1);
    double values[2];
    int count = 0;
    for (char **part = parts; *part != NULL; part++) {
        if (g_strstrip(*part)[0] == '\0') continue;
        g_autoptr(GError) reason = NULL;
        if (count == 2) return refuse(number, text, "it has more than two numbers", error);
        if (!tinker_quantity_parse(*part, dimension, &values[count++], &reason))
            return refuse(number, text, reason->message, error);
    }
    if (count != 2) return refuse(number, text, "it has fewer than two numbers", error);
    g_array_append_vals(points, values, 2);
    return TRUE;
}

GArray *tinker_point_text_parse(const char *text, TinkerDimension dimension, GError **error)
{
    g_autoptr(GArray) points = g_array_new(FALSE, FALSE, sizeof(double));
    g_auto(GStrv) parts = g_strsplit(text, ";", TINKER_MOST_POINTS + 2);
    for (int i = 0; parts[i] != NULL; i++) {
        g_strstrip(parts[i]);
        if (parts[i][0] == '\0' && parts[i + 1] == NULL) break; /* behind the last semicolon */
        if (i == TINKER_MOST_POINTS) {
            g_set_error(error, TINKER_UNITS_ERROR, TINKER_UNITS_ERROR_SYNTAX, "there are more than %d points",
                        TINKER_MOST_POINTS);
            return NULL;
        }
        if (!parse_point(parts[i], i + 1, dimension, points, error)) return NULL;
    }
    return g_steal_pointer(&points);
}

char *tinker_point_text_new(const double *points, int32_t count)
{
    GString *text = g_string_new(NULL);
    char x[32], y[32];
    for (int32_t i = 0; i < count; i++) {
        tinker_number_to_text(points[2 * i], x, sizeof x);
        tinker_number_to_text(points[2 * i + 1], y, sizeof y);
        g_string_append_printf(text, "%s%s %s", i > 0 ? "; " : "", x, y);
    }
    return g_string_free(text, FALSE);
}
