/* Draws the pictures of the methods: draw-methods FOLDER writes stability-METHOD.png for each, and the comparisons
 * order.png and numerical-damping.png. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "growth.h"
#include "region.h"

#define ROUNDING     1e-9 /* growth that is no growth */
#define ACCURATE     0.01 /* error over ten turns */
#define CURVE_POINTS 200
#define LEAST_ERROR  1e-11 /* below it is rounding */

enum { BLUE, VERMILION, GREEN, PINK };

typedef struct {
    const char *folder;
    GArray *curves;     /* of TinkerCurve */
    GPtrArray *numbers; /* theirs */
    GPtrArray *labels;
} Sheet;

static void sheet_init(Sheet *sheet, const char *folder)
{
    sheet->folder = folder;
    sheet->curves = g_array_new(FALSE, FALSE, sizeof(TinkerCurve));
    sheet->numbers = g_ptr_array_new_with_free_func(g_free);
    sheet->labels = g_ptr_array_new_with_free_func(g_free);
}

static void sheet_clear(Sheet *sheet)
{
    g_array_unref(sheet->curves);
    g_ptr_array_unref(sheet->numbers);
    g_ptr_array_unref(sheet->labels);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Sheet, sheet_clear)

static const char *keep(Sheet *sheet, char *label)
{
    g_ptr_array_add(sheet->labels, label);
    return label;
}

static void add_curve(Sheet *sheet, PlaceFunction place, const void *data, int points, TinkerCurve style)
{
    docs_add_curve(sheet->curves, sheet->numbers, place, data, points, style);
}

static gboolean sheet_write(Sheet *sheet, TinkerPlot plot, int width, int height, const char *name, GError **error)
{
    g_autofree char *path = g_strdup_printf("%s/%s.png", sheet->folder, name);
    plot.theme = tinker_theme_find("light");
    plot.curves = (const TinkerCurve *)(const void *)sheet->curves->data;
    plot.curve_count = (int)sheet->curves->len;
    return tinker_plot_to_file(&plot, width, height, path, error);
}

/* Where a step is accurate
 * --------------------------------------------------------------------------------------------- */

static gboolean is_accurate(const Method *method, double angle, double distance)
{
    return method->error(method, distance * cos(angle), distance * sin(angle)) <= ACCURATE;
}

static void place_of_accuracy(const void *data, double share, double *x, double *y)
{
    const Method *method = data;
    double angle = method->plane == PLANE_OF_ROOTS ? G_PI * (0.5 + share) : 0.5 * G_PI * share;
    double low = 1e-3, high = low;
    while (high < 20 && is_accurate(method, angle, high))
        low = high, high *= 1.05;
    for (int i = 0; i < 30; i++) {
        double middle = 0.5 * (low + high);
        if (is_accurate(method, angle, middle))
            low = middle;
        else
            high = middle;
    }
    *x = low * cos(angle);
    *y = low * sin(angle);
}

/* Regions
 * -------------------------------------------------------------------------------------------------------------- */

static void place_of_points(const void *data, double share, double *x, double *y)
{
    const double *ends = data;
    *x = ends[0] + share * (ends[2] - ends[0]);
    *y = ends[1] + share * (ends[3] - ends[1]);
}

static void add_limit(Sheet *sheet, const char *words, double limit, double x, double y)
{
    if (!(limit > 0)) return;
    const double ends[4] = {x, y, x, y};
    const char *label = keep(sheet, g_strdup_printf("%s %.4g", words, limit));
    add_curve(sheet, place_of_points, ends, 1, (TinkerCurve){.label = label, .role = TINKER_CURVE_RING});
}

static void add_limits(Sheet *sheet, const Method *method)
{
    const TinkerIntegrator *integrator = docs_integrator(method);
    double swing = integrator->imaginary_limit, damping = integrator->real_limit;
    if (method->plane == PLANE_OF_ROOTS) {
        add_limit(sheet, "undamped: ωh up to", swing, 0, swing);
        add_limit(sheet, "pure damper: hc/m up to", damping, -damping, 0);
    } else {
        add_limit(sheet, "undamped: ωh up to", swing, swing, 0);
        add_limit(sheet, "pure damper: hc/m up to", damping, 0, damping);
    }
}

/* The line of motions that are neither damped nor grow; of those that just do not swing. */
static void add_guide(Sheet *sheet, const Method *method, const double *view)
{
    const double axis[4] = {0, 2 * view[2], 0, 2 * view[3]}, critical[4] = {0, 0, view[1], 2 * view[1]};
    gboolean of_roots = method->plane == PLANE_OF_ROOTS;
    add_curve(sheet, place_of_points, of_roots ? axis : critical, 2,
              (TinkerCurve){.label = of_roots ? NULL : "critical damping, c/m = 2ω", .role = TINKER_CURVE_GUIDE});
}

/* More than is shown, since equal scales may widen either axis. */
static void widen(const Method *method, const double *view, double *wide)
{
    double share = method->plane == PLANE_OF_ROOTS ? 0.2 : 0;
    for (int axis = 0; axis < 4; axis += 2) {
        double more = share * (view[axis + 1] - view[axis]);
        wide[axis] = view[axis] - more;
        wide[axis + 1] = view[axis + 1] + more;
    }
}

static TinkerPlot plot_of_plane(const Method *method, const char *title, const double *view)
{
    gboolean of_roots = method->plane == PLANE_OF_ROOTS;
    return (TinkerPlot){.title = title,
                        .x_label = of_roots ? "Re hλ" : "ωh: radians a step",
                        .y_label = of_roots ? "Im hλ" : "hc/m: damping a step",
                        .equal_scales = of_roots,
                        .x_range = view,
                        .y_range = view + 2};
}

static gboolean draw_region(const char *folder, const Method *method, const double *view, const double size[2],
                            GError **error)
{
    static const double levels[] = {1 + ROUNDING, 0.8, 0.6, 0.4, 0.2};
    g_autofree char *title = g_strdup_printf("%s: where a step is stable", method->id);
    g_autofree char *name = g_strdup_printf("stability-%s", method->id);
    g_auto(Sheet) sheet;
    Grid grid;
    View wide;
    widen(method, view, wide);
    sheet_init(&sheet, folder);
    docs_grid_init(&grid, method, wide);
    for (gsize i = 0; i < G_N_ELEMENTS(levels); i++)
        docs_add_shade(sheet.curves, sheet.numbers, &grid, levels[i], BLUE);
    docs_add_edge(sheet.curves, sheet.numbers, &grid, levels[0], "edge of stability", BLUE);
    docs_grid_clear(&grid);
    add_guide(&sheet, method, view);
    if (method->error != NULL)
        add_curve(&sheet, place_of_accuracy, method, CURVE_POINTS,
                  (TinkerCurve){.label = "error of 1 % in ten turns", .colour = VERMILION});
    if (docs_integrator(method) != NULL) add_limits(&sheet, method);
    return sheet_write(&sheet, plot_of_plane(method, title, view), (int)size[0], (int)size[1], name, error);
}

static void place_of_bdf_edge(const void *data, double share, double *x, double *y)
{
    docs_bdf_edge(*(const int *)data, 2 * G_PI * share, x, y);
}

/* The five orders of the backward differentiation formulas in one: the more of them are stable, the darker. */
static gboolean draw_bdf(const char *folder, const Method *first, const double *view, const double size[2],
                         GError **error)
{
    static const int colours[] = {GREEN, PINK, BLUE, VERMILION, 4};
    g_autofree char *title = g_strdup_printf("%s: stable outside of the curves", first->id);
    g_autofree char *name = g_strdup_printf("stability-%s", first->id);
    g_auto(Sheet) sheet;
    View wide;
    widen(first, view, wide);
    sheet_init(&sheet, folder);
    for (const Method *method = first; method->order > 0; method++) {
        Grid grid;
        docs_grid_init(&grid, method, wide);
        docs_add_shade(sheet.curves, sheet.numbers, &grid, 1, BLUE);
        docs_grid_clear(&grid);
        const char *label = keep(&sheet, g_strdup_printf("order %d", method->order));
        add_curve(&sheet, place_of_bdf_edge, &method->order, 4 * CURVE_POINTS,
                  (TinkerCurve){.label = label, .colour = colours[method->order - 1]});
    }
    add_guide(&sheet, first, view);
    return sheet_write(&sheet, plot_of_plane(first, title, view), (int)size[0], (int)size[1], name, error);
}

static gboolean draw_method(const char *folder, const Method *method, GError **error)
{
    static const View roots = {-10, 1.5, -6.8, 6.8}, formulas = {-6, 20, -13, 13}, explicit = {0, 3.6, 0, 3.6},
                      implicit = {0, 20, 0, 20};
    static const double tall[2] = {640, 780}, square[2] = {640, 660};
    if (method->order > 0) return method->order > 1 || draw_bdf(folder, method, formulas, square, error);
    if (method->plane == PLANE_OF_ROOTS) return draw_region(folder, method, roots, tall, error);
    const TinkerIntegrator *integrator = docs_integrator(method);
    gboolean limited = integrator->imaginary_limit > 0;
    return draw_region(folder, method, limited ? explicit : implicit, square, error);
}

/* Comparisons
 * ---------------------------------------------------------------------------------------------------------- */

static void place_of_order(const void *data, double share, double *x, double *y)
{
    *x = 4 * pow(1024, share);
    *y = docs_error_of_ten_periods(data, *x);
    if (*y < LEAST_ERROR) *y = NAN;
}

static gboolean draw_orders(const char *folder, GError **error)
{
    static const char *const ids[] = {"semi-implicit-euler", "verlet", "newmark", "rk4", "verlet6"};
    g_auto(Sheet) sheet;
    sheet_init(&sheet, folder);
    for (gsize i = 0; i < G_N_ELEMENTS(ids); i++)
        add_curve(&sheet, place_of_order, ids[i], CURVE_POINTS, (TinkerCurve){.label = ids[i], .colour = (int)i});
    TinkerPlot plot = {.title = "An undamped oscillator after ten periods",
                       .x_label = "Steps a period",
                       .y_label = "Error, relative to the amplitude",
                       .x_logarithmic = TRUE,
                       .y_logarithmic = TRUE};
    return sheet_write(&sheet, plot, 800, 520, "order", error);
}

typedef struct {
    const char *id;
    double spectral_radius;
} Damper;

static void place_of_damping(const void *data, double share, double *x, double *y)
{
    const Damper *damper = data;
    *x = 0.05 * pow(4000, share);
    *y = docs_undamped_growth(damper->id, damper->spectral_radius, *x);
    if (*y > 1.1) *y = NAN;
}

static gboolean draw_damping(const char *folder, GError **error)
{
    static const Damper dampers[] = {
        {"newmark", 0},
        {"generalized-alpha", 0.9},
        {"generalized-alpha", 0.8},
        {"generalized-alpha", 0.5},
        {"generalized-alpha", 0.2},
        {"rk4", 0},
    };
    static const double range[2] = {0, 1.1};
    g_auto(Sheet) sheet;
    sheet_init(&sheet, folder);
    for (gsize i = 0; i < G_N_ELEMENTS(dampers); i++) {
        const Damper *damper = &dampers[i];
        const char *label = damper->spectral_radius == 0
                                ? damper->id
                                : keep(&sheet, g_strdup_printf("%s, ρ = %.1f", damper->id, damper->spectral_radius));
        add_curve(&sheet, place_of_damping, damper, 2 * CURVE_POINTS, (TinkerCurve){.label = label, .colour = (int)i});
    }
    TinkerPlot plot = {.title = "What a step leaves of an undamped oscillator's swing",
                       .x_label = "ωh: radians a step",
                       .y_label = "Growth a step",
                       .x_logarithmic = TRUE,
                       .y_range = range};
    return sheet_write(&sheet, plot, 800, 480, "numerical-damping", error);
}

int main(int argc, char **argv)
{
    g_autoptr(GError) error = NULL;
    if (argc != 2) {
        fprintf(stderr, "usage: draw-methods FOLDER\n");
        return 2;
    }
    gboolean drawn = draw_orders(argv[1], &error) && draw_damping(argv[1], &error);
    for (const Method *method = docs_methods; drawn && method->id != NULL; method++)
        drawn = draw_method(argv[1], method, &error);
    if (!drawn) fprintf(stderr, "draw-methods: %s\n", error->message);
    return drawn ? 0 : 1;
}
