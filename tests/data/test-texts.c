/* The launcher, the software centre's text and the translations, held against the validators of freedesktop.org and
 * against each other: a launcher that names an icon or a type that nobody installs would go unnoticed by them. */
#include <glib.h>
#include <string.h>

#include "installed.h"

#define LAUNCHER "applications/org.tinker.Tinker.desktop"
#define METAINFO "metainfo/org.tinker.Tinker.metainfo.xml"
#define MIME     "mime/packages/org.tinker.Tinker.xml"

static GKeyFile *launcher(void)
{
    g_autofree char *text = test_installed_text(LAUNCHER);
    g_autoptr(GError) error = NULL;
    GKeyFile *file = g_key_file_new();
    g_key_file_load_from_data(file, text, strlen(text), G_KEY_FILE_KEEP_TRANSLATIONS, &error);
    g_assert_no_error(error);
    return file;
}

static char *launcher_value(GKeyFile *file, const char *key)
{
    g_autoptr(GError) error = NULL;
    char *value = g_key_file_get_string(file, G_KEY_FILE_DESKTOP_GROUP, key, &error);
    g_assert_no_error(error);
    return value;
}

/* What an XPath expression gives for an installed file, without the end of the line. */
static char *xpath(const char *relative, const char *expression)
{
    g_autofree char *path = test_installed_path(relative);
    const char *arguments[] = {"xmllint", "--nonet", "--xpath", expression, path, NULL};
    return g_strchomp(test_tool_output(arguments));
}

/* The hint that two main categories (education and science) may list the program twice is no mistake: it belongs in
 * both. */
static void test_launcher_is_valid(void)
{
    g_autofree char *path = test_installed_path(LAUNCHER);
    const char *arguments[] = {"desktop-file-validate", "--no-hints", path, NULL};
    g_autofree char *output = test_tool_output(arguments);
    g_assert_cmpstr(output, ==, "");
}

/* Pedantic, but for one remark: the identifier has an upper-case letter, as those of GNOME's programs have. */
static void test_metainfo_is_valid(void)
{
    g_autofree char *path = test_installed_path(METAINFO);
    const char *arguments[] = {"appstreamcli", "validate",   "--no-net", "--no-color",
                               "--strict",     "--pedantic", path,       NULL};
    g_autofree char *output = test_tool_output(arguments);
    g_auto(GStrv) lines = g_strsplit(output, "\n", -1);
    for (guint i = 0; lines[i] != NULL; i++)
        if (g_regex_match_simple("^[EWIP]: ", lines[i], 0, 0) &&
            strstr(lines[i], "cid-contains-uppercase-letter") == NULL) {
            g_test_message("%s", lines[i]);
            g_test_fail();
        }
}

static void test_types_are_well_formed(void)
{
    g_autofree char *path = test_installed_path(MIME);
    const char *arguments[] = {"xmllint", "--nonet", "--noout", path, NULL};
    g_autofree char *output = test_tool_output(arguments);
    g_assert_cmpstr(output, ==, "");
}

/* Launcher, metainfo, type and icons speak of one program and one type. */
static void test_texts_agree(void)
{
    g_autoptr(GKeyFile) file = launcher();
    g_autofree char *types = launcher_value(file, "MimeType"), *type = xpath(MIME, "string(//@type)");
    g_autofree char *listed = g_strconcat(type, ";", NULL), *provided = xpath(METAINFO, "string(//mediatype)");
    g_assert_cmpstr(types, ==, listed);
    g_assert_cmpstr(provided, ==, type);

    g_autofree char *launchable = xpath(METAINFO, "string(//launchable)"), *name = g_path_get_basename(LAUNCHER);
    g_assert_cmpstr(launchable, ==, name);
    g_autofree char *command = launcher_value(file, "Exec"), *program = xpath(METAINFO, "string(//binary)");
    g_autofree char *opened = g_strconcat(program, " %F", NULL);
    g_assert_cmpstr(command, ==, opened);

    g_autofree char *icon = launcher_value(file, "Icon"), *stock = xpath(METAINFO, "string(//icon[@type='stock'])");
    g_assert_cmpstr(icon, ==, stock);
    g_autofree char *of_program = g_strconcat("icons/hicolor/scalable/apps/", icon, ".svg", NULL);
    g_autofree char *symbol = g_strconcat("icons/hicolor/symbolic/apps/", icon, "-symbolic.svg", NULL);
    g_autofree char *of_type =
        g_strconcat("icons/hicolor/scalable/mimetypes/", g_strdelimit(type, "/", '-'), ".svg", NULL);
    const char *files[] = {of_program, symbol, of_type};
    for (gsize i = 0; i < G_N_ELEMENTS(files); i++)
        g_free(test_installed_text(files[i]));
}

static void test_version_is_released(void)
{
    g_autofree char *newest = xpath(METAINFO, "string(//release[1]/@version)");
    g_assert_cmpstr(newest, ==, g_getenv("TINKER_VERSION"));
}

/* The files of a folder of the sources, and of those in it, that mark texts for translation, but are not in the list.
 */
static void find_unlisted(const char *folder, const char *const *listed)
{
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SOURCES"), folder, NULL);
    g_autoptr(GError) error = NULL;
    g_autoptr(GDir) dir = g_dir_open(path, 0, &error);
    g_assert_no_error(error);
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
        g_autofree char *file = g_build_filename(path, name, NULL), *text = NULL;
        g_autofree char *entry = g_strconcat(folder, "/", name, NULL);
        if (g_file_test(file, G_FILE_TEST_IS_DIR)) find_unlisted(entry, listed);
        if (!g_str_has_suffix(name, ".c") && !g_str_has_suffix(name, ".ui")) continue;
        g_assert_true(g_file_get_contents(file, &text, NULL, NULL));
        if (!g_regex_match_simple("\\b(N?C?_|ngettext)\\(\\s*\"|translatable=\"(yes|true|1)\"", text, 0, 0)) continue;
        if (g_strv_contains(listed, entry)) continue;
        g_test_message("%s is not in host/po/POTFILES", entry);
        g_test_fail();
    }
}

/* What nobody extracts nobody can translate. */
static void test_texts_are_listed(void)
{
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SOURCES"), "host", "po", "POTFILES", NULL), *text = NULL;
    g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
    g_auto(GStrv) listed = g_strsplit(g_strchomp(text), "\n", -1);
    for (guint i = 1; listed[i] != NULL; i++)
        g_assert_cmpstr(listed[i - 1], <, listed[i]);
    find_unlisted("host/common", (const char *const *)listed);
    find_unlisted("host/gui", (const char *const *)listed);
    find_unlisted("core", (const char *const *)listed);
}

/* Every string that xgettext finds has a translation in every language, none of them fuzzy, with the same placeholders
 * and a mnemonic where the original has one. */
static void test_translations_are_complete(gconstpointer language)
{
    const char *sources = g_getenv("TINKER_SOURCES");
    g_autofree char *list = g_build_filename(sources, "host", "po", "POTFILES", NULL);
    g_autofree char *name = g_strconcat(language, ".po", NULL),
                    *po = g_build_filename(sources, "host", "po", name, NULL);
    g_autofree char *strings = test_installed_path("strings.pot");
    const char *extract[] = {"xgettext",
                             "--from-code=UTF-8",
                             "-k_",
                             "-kN_",
                             "-kC_:1c,2",
                             "-kNC_:1c,2",
                             "-kngettext:1,2",
                             "-kg_dngettext:2,3",
                             "-D",
                             sources,
                             "-f",
                             list,
                             "-o",
                             strings,
                             NULL};
    g_autofree char *extracted = test_tool_output(extract);
    const char *check[] = {"msgfmt", "--check", "--check-accelerators=_", "-o", "/dev/null", po, NULL};
    g_autofree char *checked = test_tool_output(check);
    const char *compare[] = {"msgcmp", po, strings, NULL};
    g_autofree char *compared = test_tool_output(compare);
}

/* The translations are in what is installed. */
static void test_translations_are_merged(gconstpointer language)
{
    g_autoptr(GKeyFile) file = launcher();
    g_autofree char *plain = launcher_value(file, "Comment");
    g_autofree char *key = g_strdup_printf("Comment[%s]", (const char *)language),
                    *translated = launcher_value(file, key);
    g_assert_cmpstr(translated, !=, plain);

    g_autofree char *summary = g_strdup_printf("string(/component/summary[@xml:lang='%s'])", (const char *)language);
    g_autofree char *comment =
        g_strdup_printf("string(//*[local-name()='comment'][@xml:lang='%s'])", (const char *)language);
    g_autofree char *of_program = xpath(METAINFO, summary), *of_type = xpath(MIME, comment);
    g_assert_cmpstr(of_program, !=, "");
    g_assert_cmpstr(of_type, !=, "");

    g_autofree char *relative = g_strdup_printf("locale/%s/LC_MESSAGES/tinker.mo", (const char *)language);
    g_free(test_installed_text(relative));
}

/* A case for each line of host/po/LINGUAS. */
static void add_languages(void)
{
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SOURCES"), "host", "po", "LINGUAS", NULL), *text = NULL;
    g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
    g_auto(GStrv) languages = g_strsplit_set(text, " \n", -1);
    for (guint i = 0; languages[i] != NULL; i++) {
        if (*languages[i] == '\0') continue;
        g_autofree char *complete = g_strconcat("/data/translations/complete/", languages[i], NULL);
        g_autofree char *merged = g_strconcat("/data/translations/merged/", languages[i], NULL);
        g_test_add_data_func_full(complete, g_strdup(languages[i]), test_translations_are_complete, g_free);
        g_test_add_data_func_full(merged, g_strdup(languages[i]), test_translations_are_merged, g_free);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/data/launcher", test_launcher_is_valid);
    g_test_add_func("/data/metainfo", test_metainfo_is_valid);
    g_test_add_func("/data/types-well-formed", test_types_are_well_formed);
    g_test_add_func("/data/agreement", test_texts_agree);
    g_test_add_func("/data/version", test_version_is_released);
    g_test_add_func("/data/translations/listed", test_texts_are_listed);
    add_languages();
    test_installed_set_up();
    const int status = g_test_run();
    test_installed_tear_down();
    return status;
}
