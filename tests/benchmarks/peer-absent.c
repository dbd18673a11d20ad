/* The peers whose libraries were not found. */
#include "peers.h"

static const Peer none[] = {{NULL}};

#ifndef BENCHMARK_GSL
const Peer *peer_gsl(void)
{
    return none;
}
#endif

#ifndef BENCHMARK_SUNDIALS
const Peer *peer_sundials(void)
{
    return none;
}
#endif
