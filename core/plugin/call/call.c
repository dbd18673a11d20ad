/* What this thread calls a plugin for. */
#include "plugin/call/call.h"

_Thread_local const TinkerPluginCall *volatile tinker_plugin_call;
_Thread_local TinkerPluginLast tinker_plugin_last;
