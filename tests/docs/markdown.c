/* Markdown by lines: as much of it as marks, fences and links need. */
#include "markdown.h"

#include <string.h>

static void listing_free(gpointer data)
{
    MarkdownListing *listing = data;
    g_free(listing->kind);
    g_free(listing->argument);
    g_free(listing->folder);
    g_free(listing->text);
    g_free(listing);
}

/* `<!-- output: x in y -->` taken apart; NULL for any other line. */
static MarkdownListing *read_mark(const char *line)
{
    g_autoptr(GRegex) mark = g_regex_new("^<!-- (listing|output): (.+?)(?: in ([^ ]+))? -->$", 0, 0, NULL);
    g_autoptr(GMatchInfo) match = NULL;
    if (!g_regex_match(mark, line, 0, &match)) return NULL;
    MarkdownListing *listing = g_new0(MarkdownListing, 1);
    listing->kind = g_match_info_fetch(match, 1);
    listing->argument = g_match_info_fetch(match, 2);
    listing->folder = g_match_info_fetch(match, 3);
    return listing;
}

/* The lines between the fences that begin at `line`. */
static char *read_fenced(char **line)
{
    g_assert_true(*line != NULL && g_str_has_prefix(*line, "```"));
    GString *text = g_string_new(NULL);
    for (line++; *line != NULL && strcmp(*line, "```") != 0; line++)
        g_string_append_printf(text, "%s\n", *line);
    g_assert_nonnull(*line);
    return g_string_free(text, FALSE);
}

/* Folders of builds and of version control are not the project's. */
static gboolean is_project_folder(const char *name)
{
    return name[0] != '.' && !g_str_has_prefix(name, "build") && strcmp(name, "out") != 0;
}

static void collect(const char *folder, GPtrArray *files)
{
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    g_assert_nonnull(dir);
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
        g_autofree char *path = g_build_filename(folder, name, NULL);
        if (g_file_test(path, G_FILE_TEST_IS_DIR)) {
            if (is_project_folder(name)) collect(path, files);
        } else if (g_str_has_suffix(name, ".md")) {
            g_ptr_array_add(files, g_steal_pointer(&path));
        }
    }
}

GPtrArray *markdown_listings(const char *text)
{
    GPtrArray *listings = g_ptr_array_new_with_free_func(listing_free);
    g_auto(GStrv) lines = g_strsplit(text, "\n", -1);
    for (char **line = lines; *line != NULL; line++) {
        MarkdownListing *listing = read_mark(*line);
        if (listing == NULL) continue;
        g_ptr_array_add(listings, listing);
        listing->text = read_fenced(line + 1);
    }
    return listings;
}

GPtrArray *markdown_links(const char *text)
{
    GPtrArray *links = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GRegex) link = g_regex_new("\\]\\(([^)#:]+)(#[^)]*)?\\)", 0, 0, NULL);
    g_autoptr(GMatchInfo) match = NULL;
    g_regex_match(link, text, 0, &match);
    for (; g_match_info_matches(match); g_match_info_next(match, NULL))
        g_ptr_array_add(links, g_match_info_fetch(match, 1));
    return links;
}

GPtrArray *markdown_files(const char *sources)
{
    GPtrArray *files = g_ptr_array_new_with_free_func(g_free);
    collect(sources, files);
    return files;
}

char *markdown_source_path(const char *relative)
{
    return g_build_filename(g_getenv("TINKER_SOURCES"), relative, NULL);
}
