/* tinker plugins new, new-bundle: starting points for plugins of one's own. argv[0] is the verb; the answer is the exit
 * status. */
#ifndef TINKER_CLI_PLUGINS_NEW_H
#define TINKER_CLI_PLUGINS_NEW_H

int tinker_plugins_new(int argc, char **argv);
int tinker_plugins_new_bundle(int argc, char **argv);

#endif
