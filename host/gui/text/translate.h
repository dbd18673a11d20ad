/* Texts that the window shows but does not write itself: those of the blocks' and methods' descriptors, and titles and
 * descriptions of the bundled scenes. host/po/descriptors.pot lists the bundled ones for the translators; others appear
 * as they are. */
#ifndef TINKER_GUI_TRANSLATE_H
#define TINKER_GUI_TRANSLATE_H

/* The text in the user's language, or the text itself where nobody has translated it; NULL stays NULL. It may be freed
 * with `text`, else it lives as long as the program. What is stored in a scene is never translated. (transfer none) */
const char *tinker_translate(const char *text);

/* Of the title of a scene with this description (or NULL): that of a bundled one, which is told by its description, in
 * the user's language; any other as it was given, even where it equals the title of a bundled one. (transfer none) */
const char *tinker_translate_title(const char *title, const char *description);

#endif
