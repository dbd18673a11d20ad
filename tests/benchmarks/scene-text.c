/* Writing scenes; see the header. */
#include "scene-text.h"

#include <math.h>
#include <string.h>

static const char head[] = "{\"tinker\": 1, \"run\": {\"method\": \"rk4\", \"step\": 0.001}, \"blocks\": [\n";

static void add_number(GString *text, double value)
{
    char digits[G_ASCII_DTOSTR_BUF_SIZE];
    g_string_append(text, g_ascii_dtostr(digits, sizeof digits, value));
}

static void add_mass(GString *text, int number, double x, double y)
{
    g_string_append_printf(text, "{\"type\": \"mass\", \"name\": \"M%d\", \"mass\": 1, \"position\": [", number);
    add_number(text, x);
    g_string_append(text, ", ");
    add_number(text, y);
    g_string_append(text, "], \"width\": 0, \"height\": 0},\n");
}

static char *end_text(GString *text)
{
    g_string_truncate(text, text->len - 2); /* the last comma */
    g_string_append(text, "\n]}\n");
    return g_string_free(text, FALSE);
}

char *benchmark_off_line(char *text)
{
    static const char size[] = "\"width\": 0, \"height\": 0";
    char *first = strstr(text, size);
    g_assert(first != NULL);
    char *moved = g_strdup_printf("%.*s\"velocity\": [0, 1e-9], %s", (int)(first - text), text, first);
    g_free(text);
    return moved;
}

char *benchmark_oscillator(gboolean hanging)
{
    GString *text = g_string_new(head);
    if (hanging)
        g_string_append(text, "{\"type\": \"gravity\"},\n"
                              "{\"type\": \"support\", \"name\": \"S\", \"orientation\": \"180 deg\"},\n");
    else
        g_string_append(text, "{\"type\": \"support\", \"name\": \"S\", \"solid\": false},\n");
    add_mass(text, 0, hanging ? 0.0 : 3.0, hanging ? -3.0 : 0.0);
    g_string_append(text, "{\"type\": \"spring\", \"ends\": [\"S\", \"M0\"], \"stiffness\": 25, \"rest_length\": 2},\n"
                          "{\"type\": \"damper\", \"ends\": [\"S\", \"M0\"], \"damping\": 0.4},\n");
    return end_text(text);
}

char *benchmark_chain(int rods, const double *angles, double rod_length)
{
    GString *text = g_string_new(head);
    double x = 0, y = 0;
    g_string_append(text,
                    "{\"type\": \"gravity\"},\n{\"type\": \"support\", \"name\": \"S\", \"solid\": false, \"width\": "
                    "0.1, \"height\": 0.1},\n");
    for (int i = 0; i < rods; i++) {
        x += rod_length * sin(angles[i]);
        y -= rod_length * cos(angles[i]);
        add_mass(text, i, x, y);
    }
    for (int i = 0; i < rods; i++) {
        g_autofree char *above = i == 0 ? g_strdup("S") : g_strdup_printf("M%d", i - 1);
        g_string_append_printf(text, "{\"type\": \"rod\", \"ends\": [\"%s\", \"M%d\"], \"length\": ", above, i);
        add_number(text, rod_length);
        g_string_append(text, "},\n");
    }
    return end_text(text);
}

static void add_bar(GString *text, int number, double x, double y, double angle, double length)
{
    g_string_append_printf(text, "{\"type\": \"bar\", \"name\": \"B%d\", \"mass\": 1, \"position\": [", number);
    add_number(text, x);
    g_string_append(text, ", ");
    add_number(text, y);
    g_string_append(text, "], \"orientation\": ");
    add_number(text, angle);
    g_string_append(text, ", \"length\": ");
    add_number(text, length);
    g_string_append(text, "},\n");
}

static void add_pin(GString *text, int number, double length)
{
    g_string_append(text, "{\"type\": \"pin\", \"ends\": [");
    if (number == 0) g_string_append(text, "\"S\"");
    for (int end = number == 0 ? 1 : 0; end < 2; end++) {
        g_string_append_printf(text, "%s{\"block\": \"B%d\", \"at\": [", end == 1 ? ", " : "", number - 1 + end);
        add_number(text, end == 0 ? 0.5 * length : -0.5 * length);
        g_string_append(text, ", 0]}");
    }
    g_string_append(text, "]},\n");
}

char *benchmark_bars(int bars, const double *angles, double length)
{
    GString *text = g_string_new(head);
    double x = 0, y = 0;
    g_string_append(text, "{\"type\": \"gravity\"},\n{\"type\": \"support\", \"name\": \"S\", \"solid\": false},\n");
    for (int i = 0; i < bars; i++) {
        const double dx = length * sin(angles[i]), dy = -length * cos(angles[i]);
        add_bar(text, i, x + 0.5 * dx, y + 0.5 * dy, atan2(dy, dx), length);
        x += dx;
        y += dy;
    }
    for (int i = 0; i < bars; i++)
        add_pin(text, i, length);
    return end_text(text);
}

double *benchmark_hanging_angles(int count)
{
    double *angles = g_new(double, count);
    for (int i = 0; i < count; i++)
        angles[i] = 0.1 * cos(2.0 * (i + 0.5) / count);
    return angles;
}

double *benchmark_level_angles(int count)
{
    double *angles = g_new(double, count);
    for (int i = 0; i < count; i++)
        angles[i] = G_PI / 2;
    return angles;
}

/* A body that is seen. */
static void add_body(GString *text, const char *type, const char *letter, int number, double x, double y)
{
    g_string_append_printf(text, "{\"type\": \"%s\", \"name\": \"%s%d\", \"position\": [", type, letter, number);
    add_number(text, x);
    g_string_append(text, ", ");
    add_number(text, y);
    g_string_append(text, "], \"width\": 0.3, \"height\": 0.3},\n");
}

char *benchmark_net(int n)
{
    GString *text = g_string_new(head);
    for (int i = 0; i < n; i++)
        add_body(text, "support", "S", i, i, n);
    for (int i = 0; i < n * n; i++)
        add_body(text, "mass", "M", i, i % n, n - 1 - i / n);
    for (int i = 0; i < n * n; i++) {
        g_autofree char *above = i < n ? g_strdup_printf("S%d", i) : g_strdup_printf("M%d", i - n);
        g_string_append_printf(text, "{\"type\": \"spring\", \"ends\": [\"%s\", \"M%d\"], \"rest_length\": 1},\n",
                               above, i);
        if (i % n == n - 1) continue;
        g_string_append_printf(text, "{\"type\": \"spring\", \"ends\": [\"M%d\", \"M%d\"], \"rest_length\": 1},\n", i,
                               i + 1);
    }
    return end_text(text);
}

char *benchmark_pendulums(int count)
{
    GString *text = g_string_new(head);
    int columns = MAX((int)ceil(sqrt(2.0 * count)), 1);
    for (int i = 0; i < count; i++) {
        double x = 1.0 * (i % columns), y = -1.6 * (i / columns), angle = 0.5 * sin(i);
        add_body(text, "support", "S", i, x, y);
        add_body(text, "mass", "M", i, x + sin(angle), y - cos(angle));
        g_string_append_printf(text, "{\"type\": \"rod\", \"ends\": [\"S%d\", \"M%d\"]},\n", i, i);
    }
    return end_text(text);
}

static GString *begin_pile(void)
{
    GString *text = g_string_new("{\"tinker\": 1, \"run\": {\"contacts\": \"impulse\", \"step\": ");
    add_number(text, 1.0 / 60);
    g_string_append(text, ", \"duration\": 20}, \"blocks\": [{\"type\": \"gravity\"}");
    g_string_append(text, ", {\"type\": \"support\", \"position\": [0, -0.2], \"width\": 1000, \"height\": 0.4, "
                          "\"static_friction\": 0.5, \"dynamic_friction\": 0.5, \"restitution\": 0}");
    return text;
}

static void add_box(GString *text, double x, double y)
{
    g_string_append_printf(
        text, ", {\"type\": \"box\", \"width\": 0.5, \"height\": 0.5, \"mass\": 1, \"position\": [%.17g, %.17g]}", x,
        y);
}

char *benchmark_stacks(void)
{
    GString *text = begin_pile();
    for (int i = 0; i < 100; i++)
        add_box(text, 2 * (i / 10 - 5), 0.25 + 0.51 * (i % 10));
    g_string_append(text, "]}");
    return g_string_free(text, FALSE);
}

char *benchmark_wall(int boxes)
{
    GString *text = begin_pile();
    for (int i = 0; i < boxes; i++)
        add_box(text, 0.5 * (i / 10) + 0.25 * (i % 2), 0.25 + 0.5 * (i % 10));
    g_string_append(text, ", {\"type\": \"disc\", \"radius\": 1, \"mass\": 100, \"position\": [-3, 2], "
                          "\"velocity\": [20, 0]}]}");
    return g_string_free(text, FALSE);
}

/* Between -1 and 1, without a pattern: the fractions of multiples of an irrational number. */
static double scatter(int number)
{
    double multiple = 0.7548776662466927 * number;
    return 2.0 * (multiple - floor(multiple)) - 1.0;
}

double *benchmark_lattice_places(int n)
{
    double *places = g_new(double, 2 * n * n);
    for (int i = 0; i < n * n; i++) {
        places[2 * i] = i % n + 0.01 * scatter(2 * i + 1);
        places[2 * i + 1] = i / n + 0.01 * scatter(2 * i + 2);
    }
    return places;
}

static void add_damped_spring(GString *text, int a, int b, double length)
{
    g_string_append_printf(
        text, "{\"type\": \"spring\", \"ends\": [\"M%d\", \"M%d\"], \"stiffness\": 1000, \"rest_length\": ", a, b);
    add_number(text, length);
    g_string_append_printf(text, "},\n{\"type\": \"damper\", \"ends\": [\"M%d\", \"M%d\"], \"damping\": 0.5},\n", a, b);
}

char *benchmark_lattice(int n)
{
    GString *text = g_string_new(head);
    g_autofree double *places = benchmark_lattice_places(n);
    for (int i = 0; i < n * n; i++)
        add_mass(text, i, places[2 * i], places[2 * i + 1]);
    for (int i = 0; i < n * n; i++) {
        int column = i % n;
        gboolean left = column > 0;
        gboolean right = column < n - 1, above = i / n < n - 1;
        if (right) add_damped_spring(text, i, i + 1, 1.0);
        if (above) add_damped_spring(text, i, i + n, 1.0);
        if (right && above) add_damped_spring(text, i, i + n + 1, G_SQRT2);
        if (left && above) add_damped_spring(text, i, i + n - 1, G_SQRT2);
    }
    return end_text(text);
}

static const double line_spacing = 10.0; /* m: far from any passing */

double *benchmark_line_rests(int masses)
{
    double *rests = g_new(double, masses);
    for (int i = 0; i < masses; i++)
        rests[i] = line_spacing * (i + 1);
    return rests;
}

static void add_to_line(GString *text, int i, double displacement)
{
    add_mass(text, i, line_spacing * (i + 1) + displacement, 0.0);
}

/* From the mass before, or the support. */
static void add_line_spring(GString *text, int i, double stiffness, double damping)
{
    g_autofree char *behind = i == 0 ? g_strdup("S") : g_strdup_printf("M%d", i - 1);
    g_string_append_printf(text, "{\"type\": \"spring\", \"ends\": [\"%s\", \"M%d\"], \"stiffness\": ", behind, i);
    add_number(text, stiffness);
    g_string_append(text, ", \"rest_length\": ");
    add_number(text, line_spacing);
    g_string_append_printf(text, "},\n{\"type\": \"damper\", \"ends\": [\"%s\", \"M%d\"], \"damping\": ", behind, i);
    add_number(text, damping);
    g_string_append(text, "},\n");
}

char *benchmark_stiff_chain(void)
{
    GString *text = g_string_new(head);
    g_string_append(text, "{\"type\": \"support\", \"name\": \"S\", \"solid\": false},\n");
    for (int i = 0; i < BENCHMARK_STIFF_MASSES; i++)
        add_to_line(text, i, (i / 2 + 1) / 25.0);
    for (int i = 0; i < BENCHMARK_STIFF_MASSES; i++) {
        double stiffness = i % 2 == 0 ? 1e2 : 1e8;
        add_line_spring(text, i, stiffness, 0.02 * sqrt(stiffness));
    }
    return end_text(text);
}

char *benchmark_frame(void)
{
    GString *text = g_string_new(head);
    g_string_append(text,
                    "{\"type\": \"support\", \"name\": \"S\", \"solid\": false},\n"
                    "{\"type\": \"support-motion\", \"ends\": [\"S\"], \"angle\": 0, \"waveform\": {\"expression\": "
                    "\"0.05*sin(7.3*t)+0.01*sin(19.1*t)\"}},\n");
    for (int i = 0; i < BENCHMARK_STOREYS; i++)
        add_to_line(text, i, 0);
    for (int i = 0; i < BENCHMARK_STOREYS; i++)
        add_line_spring(text, i, 600 - 60 * i, 1.2);
    return end_text(text);
}

/* Neighbours right, above and in both diagonals; at the edges the count goes on, so that every mass has four springs.
 */
void benchmark_write_large(FILE *file, int masses)
{
    const int width = 400, steps[] = {1, width - 1, width, width + 1};
    fputs(head, file);
    for (int i = 0; i < masses; i++)
        fprintf(file, "{\"type\": \"mass\", \"name\": \"M%d\", \"mass\": 1, \"position\": [%d, %d]},\n", i, i % width,
                i / width);
    for (int i = 0; i < masses; i++)
        for (int k = 0; k < 4; k++)
            fprintf(file,
                    "{\"type\": \"spring\", \"name\": \"K%d\", \"ends\": [\"M%d\", \"M%d\"], \"stiffness\": 1000}%s\n",
                    4 * i + k, i, (i + steps[k]) % masses, i == masses - 1 && k == 3 ? "" : ",");
    fputs("]}\n", file);
}
