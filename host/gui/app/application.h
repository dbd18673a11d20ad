/* The application: command line, files to open, what all windows share. */
#ifndef TINKER_GUI_APPLICATION_H
#define TINKER_GUI_APPLICATION_H

#include <adwaita.h>

#include "plugin/catalogue/catalogue.h"

#define TINKER_APPLICATION_ID "org.tinker.Tinker"

#define TINKER_TYPE_APPLICATION (tinker_application_get_type())
G_DECLARE_FINAL_TYPE(TinkerApplication, tinker_application, TINKER, APPLICATION, AdwApplication)

/* (transfer full) */
TinkerApplication *tinker_application_new(void);

/* What the program ends with: of a picture that could not be taken it is not 0. */
int tinker_application_status(TinkerApplication *application);

#endif
