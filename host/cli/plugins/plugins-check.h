/* tinker plugins check. */
#ifndef TINKER_CLI_PLUGINS_CHECK_H
#define TINKER_CLI_PLUGINS_CHECK_H

/* argv[0] is "check"; the answer is the exit status. */
int tinker_plugins_check(int argc, char **argv);

#endif
