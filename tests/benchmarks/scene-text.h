/* The texts of the scenes that are measured. All are strings to be freed. */
#ifndef BENCHMARK_SCENE_TEXT_H
#define BENCHMARK_SCENE_TEXT_H

#include <glib.h>
#include <stdio.h>

/* 1 kg on a spring of 25 N/m beside a damper of 0.4 N s/m, let go 1 m from its rest. `hanging`: below a support with
 * its solid side down, with gravity; else sideways from a support that is not solid, without. */
char *benchmark_oscillator(gboolean hanging);

/* Masses of 1 kg one below the other on rods from the origin; the angle of each rod is counted from straight down. */
char *benchmark_chain(int rods, const double *angles, double rod_length);

/* Slender bars of 1 kg pinned end to end, from the origin; angles as above. */
char *benchmark_bars(int bars, const double *angles, double length);

/* A square of n times n masses of 1 kg, 1 m apart and each displaced by up to 1 cm, with a spring of 1000 N/m and a
 * damper of 0.5 N s/m to each of its 8 neighbours. The places, x and y in turns, are benchmark_lattice_places. */
char *benchmark_lattice(int n);
double *benchmark_lattice_places(int n);

/* BENCHMARK_STIFF_MASSES masses of 1 kg in a line from a support at the origin, the last one free: springs of 1e2 and
 * 1e8 N/m in turns, each with a damper of 0.02 sqrt(k). At rest at first, with the pairs on stiff springs displaced
 * together on a ramp up to 1 m. Where they would rest is benchmark_line_rests. */
#define BENCHMARK_STIFF_MASSES 50
char *benchmark_stiff_chain(void);

/* Where the masses of a line rest, m from the origin. */
double *benchmark_line_rests(int masses);

/* A frame of BENCHMARK_STOREYS storeys, lying down: masses of 1 kg in a line from a support at the origin, which moves
 * along it by 5 cm at 7.3 rad/s and by 1 cm at 19.1 rad/s; springs of 600, 540, 480 and 420 N/m, each with a damper
 * of 1.2 N s/m. At rest at first, where benchmark_line_rests has them. */
#define BENCHMARK_STOREYS 4
char *benchmark_frame(void);

/* The same masses, of which the first moves across their line by 1e-9 m/s: no motion to speak of, but the program
 * leaves the line for the plane. Takes `text`, in which masses are at rest. */
char *benchmark_off_line(char *text);

/* For pictures: a square of n times n masses of some size, 1 m apart, with a spring to each of its four neighbours,
 * hung from a row of supports. */
char *benchmark_net(int n);

/* Likewise: pendulums of 1 m, each with a support of its own, in a field half as high as it is wide. */
char *benchmark_pendulums(int count);

/* Ten stacks of ten boxes of 0.5 m and 1 kg, let go 0.01 m above one another; in impulse mode, as the next. */
char *benchmark_stacks(void);

/* A wall of boxes of 0.5 m and 1 kg, ten rows high, on a floor, and a disc of 100 kg that runs into its first column at
 * 20 m/s; in impulse mode, with steps of 1/60 s for 20 s. */
char *benchmark_wall(int boxes);

/* Writes a scene of `masses` masses and four springs for each of them. */
void benchmark_write_large(FILE *file, int masses);

/* The angles of a chain: `count` rods that hang a little beside the vertical in one smooth curve, or all level. */
double *benchmark_hanging_angles(int count);
double *benchmark_level_angles(int count);

#endif
