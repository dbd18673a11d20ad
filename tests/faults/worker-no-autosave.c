/* Without a window nothing is kept. */
#include "worker.h"

int worker_autosave(void)
{
    return 0;
}
