/* Tinker SDK: the whole contract at once. */
#ifndef TINKER_SDK_H
#define TINKER_SDK_H

#include "types.h"

#include "block.h"
#include "body.h"
#include "declare.h"
#include "edit.h"
#include "graph.h"
#include "instance.h"
#include "integrator.h"
#include "joint.h"
#include "kernels.h"
#include "law.h"
#include "physics.h"
#include "plugin.h"
#include "render.h"
#include "shapes.h"
#include "track.h"
#include "typed-law.h"
#include "units.h"

#endif
