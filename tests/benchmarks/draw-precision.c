/* Draws what bench-precision wrote as JSON: draw-precision FILE FOLDER makes one chart a scene, work-precision-s1.png
 * and so on. Each method of ours is a curve; of a library of others the best of all its methods at every error is. */
#include <cjson/cJSON.h>
#include <glib.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "render/plot/plot.h"

#define LEAST_ERROR 1e-17 /* an error of 0 has no place on a logarithmic axis */
#define WORST_ERROR 0.3   /* beyond it nothing was solved */

typedef struct {
    char *label;
    gboolean best; /* only what no other point beats in both time and error is kept */
    GArray *x, *y; /* of double */
} Line;

static void free_line(gpointer data)
{
    Line *line = data;
    g_free(line->label);
    g_array_unref(line->x);
    g_array_unref(line->y);
    g_free(line);
}

/* The line that a row belongs to; NULL where it is not drawn. */
static char *label_of(const char *scene, const char *solver, const char *side)
{
    if (strcmp(side, "peer, angles") == 0) return g_strdup("theirs, in angles");
    if (g_str_has_prefix(solver, "auto")) return strcmp(scene, "S6") == 0 ? g_strdup("auto") : NULL;
    if (strchr(solver, ',') != NULL) return NULL;
    if (strcmp(side, "peer") != 0) return g_strdup(solver);
    return g_strndup(solver, strcspn(solver, " "));
}

static Line *find_line(GPtrArray *lines, const char *label, gboolean best)
{
    for (guint i = 0; i < lines->len; i++) {
        Line *line = g_ptr_array_index(lines, i);
        if (strcmp(line->label, label) == 0) return line;
    }
    Line *line = g_new0(Line, 1);
    *line = (Line){g_strdup(label), best, g_array_new(FALSE, FALSE, sizeof(double)),
                   g_array_new(FALSE, FALSE, sizeof(double))};
    g_ptr_array_add(lines, line);
    return line;
}

/* Keeps the points in order of time, and of error as well. */
static void insert_best(Line *line, double x, double y)
{
    guint at = 0;
    while (at < line->x->len && g_array_index(line->x, double, at) <= x)
        at++;
    if (at > 0 && g_array_index(line->y, double, at - 1) <= y) return;
    while (at < line->x->len && g_array_index(line->y, double, at) >= y) {
        g_array_remove_index(line->x, at);
        g_array_remove_index(line->y, at);
    }
    g_array_insert_val(line->x, at, x);
    g_array_insert_val(line->y, at, y);
}

static const char *string(const cJSON *row, const char *key)
{
    const char *text = cJSON_GetStringValue(cJSON_GetObjectItem(row, key));
    return text != NULL ? text : "";
}

static double number(const cJSON *row, const char *key)
{
    const cJSON *item = cJSON_GetObjectItem(row, key);
    return cJSON_IsNumber(item) ? item->valuedouble : NAN;
}

static void add_row(GPtrArray *lines, const char *scene, const cJSON *row)
{
    const char *side = string(row, "side");
    double x = number(row, "seconds_least"), y = fmax(number(row, "error"), LEAST_ERROR);
    g_autofree char *label = label_of(scene, string(row, "solver"), side);
    if (strcmp(string(row, "scene"), scene) != 0 || label == NULL || !(x > 0) || !(y <= WORST_ERROR)) return;
    Line *line = find_line(lines, label, g_str_has_prefix(side, "peer"));
    if (line->best) {
        insert_best(line, x, y);
        return;
    }
    g_array_append_val(line->x, x);
    g_array_append_val(line->y, y);
}

static gboolean draw(const cJSON *rows, const char *scene, const char *title, const char *folder, GError **error)
{
    g_autoptr(GPtrArray) lines = g_ptr_array_new_with_free_func(free_line);
    g_autoptr(GArray) curves = g_array_new(FALSE, FALSE, sizeof(TinkerCurve));
    const cJSON *row;
    cJSON_ArrayForEach(row, rows) add_row(lines, scene, row);
    for (guint i = 0; i < lines->len; i++) {
        const Line *line = g_ptr_array_index(lines, i);
        TinkerCurve curve = {.label = line->label, .count = line->x->len, .colour = (int)i, .markers = TRUE};
        curve.x = (const double *)(gpointer)line->x->data;
        curve.y = (const double *)(gpointer)line->y->data;
        g_array_append_val(curves, curve);
    }
    if (curves->len == 0) return TRUE;
    TinkerPlot plot = {
        .title = title,
        .x_label = "Time to compute [s]",
        .y_label = "Error",
        .x_logarithmic = TRUE,
        .y_logarithmic = TRUE,
        .curves = (const TinkerCurve *)(gpointer)curves->data,
        .curve_count = (int)curves->len,
        .theme = tinker_theme_find("light"),
    };
    g_autofree char *small = g_ascii_strdown(scene, -1), *name = g_strdup_printf("work-precision-%s.png", small);
    g_autofree char *path = g_build_filename(folder, name, NULL);
    return tinker_plot_to_file(&plot, 900, 600, path, error);
}

static gboolean draw_all(const char *file, const char *folder, GError **error)
{
    g_autofree char *text = NULL;
    if (!g_file_get_contents(file, &text, NULL, error)) return FALSE;
    cJSON *whole = cJSON_Parse(text);
    const cJSON *rows = cJSON_GetObjectItem(whole, "precision");
    gboolean done = draw(rows, "S1", "S1: damped oscillator, 100 s", folder, error) &&
                    draw(rows, "S2", "S2: double pendulum, 5 s", folder, error) &&
                    draw(rows, "S6", "S6: stiff chain of 50 masses, 10 s", folder, error);
    cJSON_Delete(whole);
    return done;
}

int main(int argc, char **argv)
{
    g_autoptr(GError) error = NULL;
    if (argc != 3) {
        fprintf(stderr, "usage: draw-precision FILE FOLDER, with the JSON of bench-precision\n");
        return 2;
    }
    if (draw_all(argv[1], argv[2], &error)) return 0;
    fprintf(stderr, "draw-precision: %s\n", error->message);
    return 5;
}
