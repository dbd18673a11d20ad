/* A shared object that is no plugin. */
#include <tinker/types.h>

TINKER_EXPORT int exhibit_answer(void);

int exhibit_answer(void)
{
    return 42;
}
