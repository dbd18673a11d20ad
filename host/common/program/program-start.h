/* What every program of ours begins with. */
#ifndef TINKER_COMMON_PROGRAM_START_H
#define TINKER_COMMON_PROGRAM_START_H

/* First of all in main, before there are threads: crashes and the want of memory are told under this name
 * (plugin/crash.h), and children can be waited for, and a limit of the size of files is an error like another. */
void tinker_program_start(const char *name);

#endif
