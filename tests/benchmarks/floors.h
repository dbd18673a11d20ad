/* The floor: what the same motion costs in plain C that was written for the one scene and knows nothing else. It takes
 * the same steps, classical Runge-Kutta ones but for the stiff chain and pinned bars (and, with rods, the same return
 * to them after each), so the difference is the price of blocks, plugins, watching and energy books. */
#ifndef BENCHMARK_FLOORS_H
#define BENCHMARK_FLOORS_H

typedef struct {
    double x, v; /* displacement from the spring's rest */
} FloorOscillator;
void floor_oscillator_steps(FloorOscillator *at, double h, long steps);

/* Angles from straight down and their rates; both rods 1 m, both masses 1 kg. */
typedef struct {
    double angle[2], rate[2];
} FloorDoublePendulum;
void floor_double_pendulum_steps(FloorDoublePendulum *at, double h, long steps);

/* Masses of 1 kg on rods from the origin. */
typedef struct FloorChain FloorChain;
FloorChain *floor_chain_new(int rods, const double *angles, double rod_length);
void floor_chain_free(FloorChain *chain);
void floor_chain_reset(FloorChain *chain);
void floor_chain_steps(FloorChain *chain, double h, long steps);
/* The largest error of a length, relative. */
double floor_chain_error(const FloorChain *chain);

/* Bars of 1 kg pinned end to end from the origin, without width, by RATTLE: the steps that verlet takes. */
typedef struct FloorBars FloorBars;
FloorBars *floor_bars_new(int bars, const double *angles, double length);
void floor_bars_free(FloorBars *chain);
void floor_bars_reset(FloorBars *chain);
void floor_bars_steps(FloorBars *chain, double h, long steps);
/* The largest gap of a pin, over a bar's length. */
double floor_bars_error(FloorBars *chain);

/* The lattice of benchmark_lattice, as a list of springs. */
typedef struct FloorLattice FloorLattice;
FloorLattice *floor_lattice_new(int n, const double *places);
void floor_lattice_free(FloorLattice *lattice);
void floor_lattice_steps(FloorLattice *lattice, double h, long steps);
int floor_lattice_springs(const FloorLattice *lattice);
/* Where a mass is now. */
void floor_lattice_place(const FloorLattice *lattice, int mass, double place[2]);

/* The frame of benchmark_frame: displacements from rest, at rest at first. */
typedef struct {
    double x[4], v[4];
    long steps; /* that have been taken */
} FloorFrame;
void floor_frame_steps(FloorFrame *at, double h, long steps);

/* The chain of benchmark_stiff_chain, by average acceleration (Newmark's method). */
typedef struct FloorStiffChain FloorStiffChain;
FloorStiffChain *floor_stiff_chain_new(double h);
void floor_stiff_chain_free(FloorStiffChain *chain);
void floor_stiff_chain_reset(FloorStiffChain *chain);
void floor_stiff_chain_steps(FloorStiffChain *chain, long steps);
/* A mass's displacement from its rest. */
double floor_stiff_chain_place(const FloorStiffChain *chain, int mass);

#endif
