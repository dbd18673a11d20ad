/* A German locale of the test's own: gettext translates nothing where the locale is C. */
#ifndef TEST_GUI_GERMAN_H
#define TEST_GUI_GERMAN_H

#define GERMAN_LOCALE "de_DE.UTF-8"

/* Compiles the locale, from the system's definitions of the package "locales", and speaks German from here on, as
 * main.c of the window does; the catalogue is that of TINKER_LOCALE_FOLDER. */
void german_begin(void);

/* Deletes its files. */
void german_end(void);

/* Where they are. Borrowed. */
const char *german_folder(void);

/* Runs a program in that locale, which has to end well. The output is transferred full. */
void german_run_tool(const char *const *arguments, char **output);

#endif
