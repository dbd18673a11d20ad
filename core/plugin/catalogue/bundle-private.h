/* Bundles: what a marked folder says of itself. */
#ifndef TINKER_PLUGIN_BUNDLE_PRIVATE_H
#define TINKER_PLUGIN_BUNDLE_PRIVATE_H

#include "plugin/catalogue/catalogue.h"

/* Whether the folder carries the marker of a bundle, of whatever kind and content. */
gboolean tinker_bundle_is_marked(const char *folder);

/* Reads the marker of a folder. NULL with _REFUSED where somebody else could have changed the folder, the folder it
 * lies in or the marker, or where the marker is not one; the message reads on from "the bundle ... is passed over: ".
 * (transfer full) */
TinkerBundleEntry *tinker_bundle_read(const char *folder, GError **error);
void tinker_bundle_free(gpointer bundle);

#endif
