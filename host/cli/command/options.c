/* Command lines: parsing by GLib, with errors and help in the program's own words. */
#include "cli/command/options.h"

#include <stdio.h>
#include <string.h>

#include "common/program/exit-status.h"
#include "units/quantity/units.h"

void tinker_command_line_clear(TinkerCommandLine *line)
{
    g_clear_pointer(&line->plugin_folders, g_strfreev);
    g_clear_pointer(&line->operands, g_strfreev);
}

char *tinker_did_you_mean(const char *word, const char *const *candidates)
{
    const char *nearest = tinker_nearest_word(word, candidates);
    return nearest == NULL ? g_strdup("") : g_strdup_printf(" (did you mean \"%s\"?)", nearest);
}

static gboolean entry_has_name(const GOptionEntry *entries, const char *name)
{
    for (const GOptionEntry *entry = entries; entry->long_name != NULL; entry++)
        if (strcmp(entry->long_name, name) == 0) return TRUE;
    return FALSE;
}

/* The first "--name" that is no option of the verb's, without what follows "="; NULL where the culprit is a letter. */
static char *unknown_option(char **argv, const GOptionEntry *entries)
{
    for (char **word = argv + 1; *word != NULL; word++) {
        if (strcmp(*word, "--") == 0) return NULL;
        if (!g_str_has_prefix(*word, "--")) continue;
        g_autofree char *name = g_strndup(*word + 2, strcspn(*word + 2, "="));
        if (!entry_has_name(entries, name)) return g_steal_pointer(&name);
    }
    return NULL;
}

static void report_unknown_option(const TinkerVerbHelp *help, const char *name, const GOptionEntry *entries)
{
    g_autoptr(GPtrArray) names = g_ptr_array_new();
    for (const GOptionEntry *entry = entries; entry->long_name != NULL; entry++)
        if (entry->long_name[0] != '\0') g_ptr_array_add(names, (gpointer)entry->long_name);
    g_ptr_array_add(names, NULL);
    const char *nearest = tinker_nearest_word(name, (const char *const *)names->pdata);
    if (nearest != NULL)
        tinker_report_note("unknown option --%s (did you mean --%s?)", name, nearest);
    else
        tinker_report_note("unknown option --%s (see tinker %s --help)", name, help->verb);
}

/* GLib begins its messages with a capital; here they stand behind "tinker: ". */
static void report_as_sentence_part(const TinkerVerbHelp *help, const char *message)
{
    tinker_report_note("%c%s (see tinker %s --help)", g_ascii_tolower(message[0]), message + 1, help->verb);
}

static void print_help(GOptionContext *context)
{
    g_autofree char *text = g_option_context_get_help(context, TRUE, NULL);
    /* GLib's headings speak of an application; this is one verb of it */
    g_autoptr(GString) mended = g_string_new(text);
    g_string_replace(mended, "Application Options:", "Options:", 1);
    g_string_replace(mended, "[OPTION…]", "[OPTION...]", 1);
    fputs(mended->str, stdout);
}

static gboolean count_fits(const TinkerCommandLine *line, const TinkerVerbHelp *help)
{
    if (line->operand_count < help->least_operands) {
        tinker_report_note("%s: an operand is missing (usage: tinker %s %s)", help->verb, help->verb, help->operands);
        return FALSE;
    }
    if (help->most_operands >= 0 && line->operand_count > help->most_operands) {
        tinker_report_note("%s: \"%s\" is one operand too many (usage: tinker %s%s%s)", help->verb,
                           line->operands[help->most_operands], help->verb, help->operands[0] != '\0' ? " " : "",
                           help->operands);
        return FALSE;
    }
    return TRUE;
}

/* The verb's own entries, then those of every verb. */
static GArray *all_entries(const GOptionEntry *entries, TinkerCommandLine *line, gboolean *wants_help)
{
    const GOptionEntry common[] = {
        {"plugins", 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &line->plugin_folders,
         "Look for plugins in DIR first (may be given several times)", "DIR"},
        {"help", 'h', 0, G_OPTION_ARG_NONE, wants_help, "Show this help", NULL},
        {G_OPTION_REMAINING, 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &line->operands, NULL, NULL},
    };
    GArray *all = g_array_new(TRUE, TRUE, sizeof(GOptionEntry));
    for (const GOptionEntry *entry = entries; entry->long_name != NULL; entry++)
        g_array_append_vals(all, entry, 1);
    g_array_append_vals(all, common, G_N_ELEMENTS(common));
    return all;
}

static GOptionContext *new_context(const TinkerVerbHelp *help, const GOptionEntry *entries)
{
    GOptionContext *context = g_option_context_new(help->operands);
    g_autofree char *program = g_strdup_printf("tinker %s", help->verb);
    g_set_prgname(program);
    g_option_context_set_help_enabled(context, FALSE);
    g_option_context_set_summary(context, help->summary);
    g_autofree char *examples = help->examples == NULL ? NULL : g_strdup_printf("Examples:\n%s", help->examples);
    g_option_context_set_description(context, examples);
    g_option_context_add_main_entries(context, entries, NULL);
    return context;
}

gboolean tinker_command_line_read(TinkerCommandLine *line, const TinkerVerbHelp *help, const GOptionEntry *entries,
                                  int argc, char **argv, int *status)
{
    gboolean wants_help = FALSE;
    g_autoptr(GArray) all = all_entries(entries, line, &wants_help);
    const GOptionEntry *table = (const GOptionEntry *)(gpointer)all->data;
    g_autoptr(GOptionContext) context = new_context(help, table);

    g_autofree char **words = g_memdup2(argv, (gsize)(argc + 1) * sizeof(char *));
    g_autoptr(GError) error = NULL;
    if (!g_option_context_parse(context, &argc, &words, &error)) {
        g_autofree char *name =
            g_error_matches(error, G_OPTION_ERROR, G_OPTION_ERROR_UNKNOWN_OPTION) ? unknown_option(argv, table) : NULL;
        if (name != NULL)
            report_unknown_option(help, name, table);
        else
            report_as_sentence_part(help, error->message);
        *status = TINKER_EXIT_USAGE;
        return FALSE;
    }
    if (wants_help) {
        print_help(context);
        *status = TINKER_EXIT_DONE;
        return FALSE;
    }
    if (line->operands == NULL) line->operands = g_new0(char *, 1);
    line->operand_count = (int)g_strv_length(line->operands);
    *status = count_fits(line, help) ? TINKER_EXIT_DONE : TINKER_EXIT_USAGE;
    return *status == TINKER_EXIT_DONE;
}

static gboolean begins_with_number(const char *text)
{
    return g_ascii_isdigit(text[strspn(text, " \t+-.")]);
}

gboolean tinker_option_value(const char *option, const char *text, TinkerDimension dimension, double least,
                             gboolean open, double *si, GError **error)
{
    static const TinkerDimension time = {.time = 1};
    g_autoptr(GError) reason = NULL;
    if (!begins_with_number(text)) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--%s \"%s\": a %s is expected here, as in 12%s",
                    option, text, tinker_dimension_equal(dimension, time) ? "time" : "number",
                    tinker_dimension_equal(dimension, time) ? " or 12 ms" : "");
        return FALSE;
    }
    if (!tinker_quantity_parse(text, dimension, si, &reason)) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--%s \"%s\": %s", option, text, reason->message);
        return FALSE;
    }
    if (*si > least || (!open && *si == least)) return TRUE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--%s \"%s\": must be %s %g", option, text,
                open ? "greater than" : "at least", least);
    return FALSE;
}

gboolean tinker_option_integer(const char *option, const char *text, int least, int greatest, int *value,
                               GError **error)
{
    gint64 number = 0;
    if (!g_ascii_string_to_signed(text, 10, least, greatest, &number, NULL)) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--%s \"%s\": not a whole number from %d to %d",
                    option, text, least, greatest);
        return FALSE;
    }
    *value = (int)number;
    return TRUE;
}

gboolean tinker_option_choice(const char *option, const char *text, const char *const *words, int *place,
                              GError **error)
{
    for (int i = 0; words[i] != NULL; i++) {
        if (g_ascii_strcasecmp(words[i], text) != 0) continue;
        *place = i;
        return TRUE;
    }
    g_autofree char *list = g_strjoinv(", ", (char **)words);
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--%s \"%s\": not one of %s", option, text, list);
    return FALSE;
}
