/* The verbs of the program, one file each. argv[0] is the verb; the answer is the exit status. */
#ifndef TINKER_CLI_VERBS_H
#define TINKER_CLI_VERBS_H

int tinker_verb_run(int argc, char **argv);
int tinker_verb_graph(int argc, char **argv);
int tinker_verb_render(int argc, char **argv);
int tinker_verb_animate(int argc, char **argv);
int tinker_verb_check(int argc, char **argv);
int tinker_verb_convert(int argc, char **argv);
int tinker_verb_plan(int argc, char **argv);
int tinker_verb_equations(int argc, char **argv);
int tinker_verb_diagram(int argc, char **argv);
int tinker_verb_books(int argc, char **argv);
int tinker_verb_plugins(int argc, char **argv);
int tinker_verb_trade(int argc, char **argv);
int tinker_verb_modes(int argc, char **argv);
int tinker_verb_bench(int argc, char **argv);
int tinker_verb_demo(int argc, char **argv);

#endif
