/* What `tinker equations` writes, read back. */
#include "written.h"

#include <math.h>
#include <string.h>

cJSON *written_json(CliFixture *fixture, const char *command)
{
    g_autoptr(TestProgram) program = cli_run_well(fixture, command);
    cJSON *root = cJSON_Parse(program->output);
    g_assert_nonnull(root);
    return root;
}

double written_symbol(const cJSON *root, const char *name)
{
    const cJSON *symbol = cJSON_GetObjectItemCaseSensitive(cJSON_GetObjectItem(root, "symbols"), name);
    g_assert_nonnull(symbol);
    return cJSON_GetObjectItem(symbol, "value")->valuedouble;
}

void written_assert_near(double value, double expected, double within)
{
    if (!(fabs(value - expected) <= within)) g_error("%.15g where %.15g was expected", value, expected);
}

void written_assert_page(CliFixture *fixture, const char *command, const char *const lines[])
{
    g_autoptr(TestProgram) page = cli_run_well(fixture, command);
    g_autofree char *shown = g_utf8_normalize(page->output, -1, G_NORMALIZE_DEFAULT_COMPOSE);
    for (; *lines != NULL; lines++) {
        g_autofree char *wanted = g_utf8_normalize(*lines, -1, G_NORMALIZE_DEFAULT_COMPOSE);
        cli_assert_holds(shown, wanted);
    }
}

static double value_of_name(const WrittenValues *known, const char *name)
{
    const double *value = g_hash_table_lookup(known->values, name);
    if (value != NULL) return *value;
    for (int i = 0; i < 2; i++)
        for (const cJSON *each = cJSON_GetArrayItem(known->definitions[i], 0); each != NULL; each = each->next)
            if (strcmp(cJSON_GetObjectItem(each, "symbol")->valuestring, name) == 0)
                return written_value(known, cJSON_GetObjectItem(each, "is"));
    g_error("%s has no value", name);
}

double written_value(const WrittenValues *known, const cJSON *expression)
{
    if (cJSON_IsNumber(expression)) return expression->valuedouble;
    if (cJSON_IsString(expression)) return value_of_name(known, expression->valuestring);
    const char *what = cJSON_GetArrayItem(expression, 0)->valuestring;
    const int count = cJSON_GetArraySize(expression);
    double value = written_value(known, cJSON_GetArrayItem(expression, 1));
    if (strcmp(what, "sin") == 0) return sin(value);
    if (strcmp(what, "cos") == 0) return cos(value);
    if (strcmp(what, "sqrt") == 0) return sqrt(value);
    if (strcmp(what, "atan2") == 0) return atan2(value, written_value(known, cJSON_GetArrayItem(expression, 2)));
    if (strcmp(what, "-") == 0 && count == 2) return -value;
    for (int i = 2; i < count; i++) {
        const double next = written_value(known, cJSON_GetArrayItem(expression, i));
        g_assert_nonnull(strchr("+-*/^", what[0]));
        value = what[0] == '+'   ? value + next
                : what[0] == '-' ? value - next
                : what[0] == '*' ? value * next
                : what[0] == '/' ? value / next
                                 : pow(value, next);
    }
    return value;
}

void written_know(WrittenValues *known, const char *name, double value)
{
    double *kept = g_new(double, 1);
    *kept = value;
    g_hash_table_insert(known->values, g_strdup(name), kept);
}

WrittenValues written_values(const cJSON *root)
{
    WrittenValues known = {g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free),
                           {cJSON_GetObjectItem(root, "definitions"), NULL}};
    const cJSON *each;
    cJSON_ArrayForEach(each, cJSON_GetObjectItem(root, "symbols"))
        written_know(&known, each->string, cJSON_GetObjectItem(each, "value")->valuedouble);
    return known;
}

void written_assert_all(const cJSON *root)
{
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "not_written")), ==, 0);
}
