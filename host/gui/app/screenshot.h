/* A picture of the window, taken by the program itself: the same bytes whenever the same scene is shown. */
#ifndef TINKER_GUI_SCREENSHOT_H
#define TINKER_GUI_SCREENSHOT_H

#include <adwaita.h>

#include "gui/app/command-line.h"
#include "plugin/catalogue/catalogue.h"

/* What must be set before GTK is: the renderer, the theme. */
void tinker_screenshot_prepare(const TinkerScreenshot *screenshot);

/* Shows the scene in a window, takes the picture when everything has been drawn, and calls `done` with the exit status;
 * errors have been told on standard error. The screenshot is borrowed, and outlives it. */
typedef void (*TinkerScreenshotDone)(int status, gpointer data);
void tinker_screenshot_take(AdwApplication *application, TinkerCatalogue *catalogue, const TinkerScreenshot *screenshot,
                            TinkerScreenshotDone done, gpointer data);

#endif
