/* One key file for the process, read when it is first asked for. */
#include "gui/text/settings.h"

static GKeyFile *file;
static gboolean disabled;

static char *file_path(void)
{
    return g_build_filename(g_get_user_config_dir(), "tinker", "window.ini", NULL);
}

void tinker_settings_disable(void)
{
    disabled = TRUE;
}

static GKeyFile *key_file(void)
{
    if (file != NULL) return file;
    file = g_key_file_new();
    g_autofree char *path = file_path();
    if (!disabled) g_key_file_load_from_file(file, path, G_KEY_FILE_KEEP_COMMENTS, NULL);
    return file;
}

int tinker_settings_integer(const char *group, const char *key, int otherwise)
{
    g_autoptr(GError) error = NULL;
    int value = g_key_file_get_integer(key_file(), group, key, &error);
    return error == NULL ? value : otherwise;
}

gboolean tinker_settings_switch(const char *group, const char *key, gboolean otherwise)
{
    g_autoptr(GError) error = NULL;
    gboolean value = g_key_file_get_boolean(key_file(), group, key, &error);
    return error == NULL ? value : otherwise;
}

char *tinker_settings_text(const char *group, const char *key, const char *otherwise)
{
    g_autofree char *value = g_key_file_get_string(key_file(), group, key, NULL);
    return value != NULL ? g_steal_pointer(&value) : g_strdup(otherwise);
}

void tinker_settings_set_integer(const char *group, const char *key, int value)
{
    g_key_file_set_integer(key_file(), group, key, value);
}

void tinker_settings_set_switch(const char *group, const char *key, gboolean value)
{
    g_key_file_set_boolean(key_file(), group, key, value);
}

void tinker_settings_set_text(const char *group, const char *key, const char *value)
{
    g_key_file_set_string(key_file(), group, key, value);
}

void tinker_settings_store(void)
{
    if (disabled) return;
    g_autofree char *path = file_path(), *folder = g_path_get_dirname(path);
    g_mkdir_with_parents(folder, 0700);
    g_key_file_save_to_file(key_file(), path, NULL);
}
