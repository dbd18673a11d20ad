/* tinker-gui, the program with a window. Numbers are read and written in the C locale everywhere; texts and characters
 * follow the user's. */
#include <gtk/gtk.h>
#include <libintl.h>
#include <locale.h>

#include "common/program/installation.h"
#include "common/program/program-start.h"
#include "gui/app/application.h"

int main(int argc, char **argv)
{
    tinker_program_start("tinker-gui");
    g_autofree char *locale_folder = tinker_installation_locale_folder();
    gtk_disable_setlocale();
    setlocale(LC_CTYPE, "");
    setlocale(LC_MESSAGES, "");
    bindtextdomain(GETTEXT_PACKAGE, locale_folder);
    bind_textdomain_codeset(GETTEXT_PACKAGE, "UTF-8");
    textdomain(GETTEXT_PACKAGE);
    g_autoptr(TinkerApplication) application = tinker_application_new();
    int status = g_application_run(G_APPLICATION(application), argc, argv);
    return status != 0 ? status : tinker_application_status(application);
}
