/* Who may have written a library: owner, mode, group, and the same of its folder. */
#include <glib/gstdio.h>
#include <grp.h>
#include <linux/posix_acl.h>
#include <linux/posix_acl_xattr.h>
#include <pwd.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include "fixture.h"

/* What is said of the library, found through a manifest that matches, so that only its permissions are in question. */
static void expect_refused(const Place *place, const char *path, const char *message)
{
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_assert_cmpstr(entry_of(catalogue, path)->refused, ==, message);
    g_autoptr(GError) error = NULL;
    const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, "pull", &error);
    g_assert_true((block_class == NULL) == (message != NULL));
    g_assert_true((error == NULL) == (message == NULL));
}

/* A link is refused for the folder of what it leads to. */
static void expect_folder_refused(const Place *place, const char *link, const char *target)
{
    g_autofree char *message = g_strdup_printf(
        "it leads to \"%s\": its folder can be written by everybody (mode 0777); only its owner may", target);
    expect_refused(place, link, message);
}

static char *install(const Place *place, const char *folder)
{
    char *path = install_module("good", folder, "pull.so");
    g_autofree char *manifest = describe(path);
    g_autofree char *beside = install_text(manifest, folder, "pull.manifest.json");
    return path;
}

static void test_file(Place *place, gconstpointer data)
{
    g_autofree char *path = install(place, place->first);
    g_assert_cmpint(g_chmod(path, 0646), ==, 0);
    expect_refused(place, path, "it can be written by everybody (mode 0646); only its owner may");
    g_assert_cmpint(g_chmod(path, 0644), ==, 0);
    expect_refused(place, path, NULL);
}

static void test_folder(Place *place, gconstpointer data)
{
    g_autofree char *path = install(place, place->first);
    // A sticky bit keeps others from deleting files, not from adding some.
    g_assert_cmpint(g_chmod(place->first, 01777), ==, 0);
    expect_refused(place, path, "its folder can be written by everybody (mode 1777); only its owner may");
    g_assert_cmpint(g_chmod(place->first, 0755), ==, 0);
    expect_refused(place, path, NULL);
}

/* Who may write above can replace the whole folder, unless a sticky bit keeps others from it. */
static void test_folder_above(Place *place, gconstpointer data)
{
    g_autofree char *path = install(place, place->first);
    g_assert_cmpint(g_chmod(place->root, 0777), ==, 0);
    g_autofree char *message = g_strdup_printf(
        "the folder \"%s\" above it can be written by everybody (mode 0777); only its owner may", place->root);
    expect_refused(place, path, message);
    g_assert_cmpint(g_chmod(place->root, 01777), ==, 0);
    expect_refused(place, path, NULL);
    g_assert_cmpint(g_chmod(place->root, 0700), ==, 0);
}

/* The folder is a link into one that others can replace. */
static void test_folder_link(Place *place, gconstpointer data)
{
    g_autofree char *above = g_build_filename(place->root, "above", NULL),
                    *folder = g_build_filename(above, "real", NULL);
    g_assert_cmpint(g_mkdir_with_parents(folder, 0755), ==, 0);
    g_autofree char *path = install(place, folder), *link = g_build_filename(place->first, "link", NULL);
    g_assert_cmpint(symlink(folder, link), ==, 0);
    const char *const folders[] = {link, NULL};
    place->options.folders = folders;
    g_autofree char *found = g_build_filename(link, "pull.so", NULL);
    expect_refused(place, found, NULL);
    g_assert_cmpint(g_chmod(above, 0777), ==, 0);
    g_autofree char *message = g_strdup_printf(
        "it leads to \"%s\": the folder \"%s\" above it can be written by everybody (mode 0777); only its owner may",
        path, above);
    expect_refused(place, found, message);
    g_assert_cmpint(g_chmod(above, 0755), ==, 0);
}

/* The link lies in a safe folder, the file behind it does not. */
static void test_link(Place *place, gconstpointer data)
{
    g_autofree char *target = install_module("good", place->second, "target");
    g_autofree char *link = g_build_filename(place->first, "pull.so", NULL);
    g_assert_cmpint(symlink(target, link), ==, 0);
    expect_refused(place, link, NULL);
    g_assert_cmpint(g_chmod(place->second, 0777), ==, 0);
    expect_folder_refused(place, link, target);
}

/* A link to a link: the one between lies where others can replace it, in a folder that neither end lies in. */
static void test_link_between(Place *place, gconstpointer data)
{
    g_autofree char *open = g_build_filename(place->root, "open", NULL), *between = g_build_filename(open, "one", NULL);
    g_assert_cmpint(g_mkdir(open, 0755), ==, 0);
    g_autofree char *target = install_module("good", place->second, "target");
    g_autofree char *link = g_build_filename(place->first, "pull.so", NULL);
    // Relative, by a step back.
    g_assert_cmpint(symlink("../open/one", link), ==, 0);
    g_assert_cmpint(symlink(target, between), ==, 0);
    expect_refused(place, link, NULL);
    g_assert_cmpint(g_chmod(open, 0777), ==, 0);
    g_autofree char *way = g_build_filename(place->first, "../open/one", NULL);
    expect_folder_refused(place, link, way);
    g_assert_cmpint(g_chmod(open, 0755), ==, 0);
}

/* A link to a folder, in a folder where everybody may put links, but only replace their own. */
static void test_owner_of_link(Place *place, gconstpointer data)
{
    if (geteuid() != 0) {
        g_test_skip("only root can give files away");
        return;
    }
    g_autofree char *open = g_build_filename(place->root, "open", NULL), *link = g_build_filename(open, "link", NULL);
    g_assert_cmpint(g_mkdir(open, 0755), ==, 0);
    g_assert_cmpint(g_chmod(open, 01777), ==, 0);
    g_autofree char *path = install(place, place->second);
    g_assert_cmpint(symlink(place->second, link), ==, 0);
    const char *const folders[] = {link, NULL};
    place->options.folders = folders;
    g_autofree char *found = g_build_filename(link, "pull.so", NULL);
    expect_refused(place, found, NULL);
    g_assert_cmpint(lchown(link, 4321, (gid_t)-1), ==, 0);
    g_autofree char *message = g_strdup_printf(
        "the link \"%s\" on the way to it belongs to the user 4321, not to root, to you (0) or to the owner of this "
        "program (0)",
        link);
    expect_refused(place, found, message);
}

/* What others can write is not believed: the library is probed. */
static void test_manifest(Place *place, gconstpointer data)
{
    g_autofree char *path = install(place, place->first);
    g_autofree char *manifest = g_build_filename(place->first, "pull.manifest.json", NULL);
    g_assert_cmpint(g_chmod(manifest, 0666), ==, 0);
    expect_refused(place, path, NULL);
    g_assert_cmpuint(probe_count(place), ==, 1);
}

/* The missing type's message tells the reason, though the library's folder says nothing but a file name. */
static void test_reason_in_message(Place *place, gconstpointer data)
{
    g_autofree char *path = install_module("good", place->first, "tinker-pull.so");
    g_assert_cmpint(g_chmod(path, 0666), ==, 0);
    g_autoptr(TinkerCatalogue) catalogue = tinker_catalogue_new(&place->options);
    g_autoptr(GError) error = NULL;
    g_assert_null(tinker_catalogue_type(catalogue, "pull", &error));
    g_assert_error(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_MISSING);
    g_autofree char *message =
        g_strdup_printf("no plugin provides the block type \"pull\": the library \"%s\" was refused: it can be written "
                        "by everybody (mode 0666); only its owner may",
                        path);
    g_assert_cmpstr(error->message, ==, message);
}

/* A group of which only this user is a member may write; a group with another member may not. */
static void test_group(Place *place, gconstpointer data)
{
    const struct passwd *other = getpwnam("daemon");
    if (geteuid() != 0 || other == NULL) {
        g_test_skip("only the superuser can give files to groups");
        return;
    }
    const gid_t group = other->pw_gid;
    g_autofree char *path = install(place, place->first);
    g_assert_cmpint(g_chmod(path, 0664), ==, 0);
    expect_refused(place, path, NULL);
    g_assert_cmpint(chown(path, (uid_t)-1, group), ==, 0);
    g_autofree char *message =
        g_strdup_printf("it can be written by the group %u, which has other members (daemon; mode 0664)", group);
    expect_refused(place, path, message);
}

typedef struct {
    struct posix_acl_xattr_header header;
    struct posix_acl_xattr_entry entries[5];
} AccessList;

/* Owner and group may write by the mode; so may one user or group by name, as far as the mask lets them. */
static gboolean give_list(const char *path, guint16 kind, guint32 number, guint16 mask)
{
    const AccessList list = {{GUINT32_TO_LE(POSIX_ACL_XATTR_VERSION)},
                             {{GUINT16_TO_LE(ACL_USER_OBJ), GUINT16_TO_LE(7), GUINT32_TO_LE(ACL_UNDEFINED_ID)},
                              {GUINT16_TO_LE(kind), GUINT16_TO_LE(6), GUINT32_TO_LE(number)},
                              {GUINT16_TO_LE(ACL_GROUP_OBJ), GUINT16_TO_LE(4), GUINT32_TO_LE(ACL_UNDEFINED_ID)},
                              {GUINT16_TO_LE(ACL_MASK), GUINT16_TO_LE(mask), GUINT32_TO_LE(ACL_UNDEFINED_ID)},
                              {GUINT16_TO_LE(ACL_OTHER), GUINT16_TO_LE(4), GUINT32_TO_LE(ACL_UNDEFINED_ID)}}};
    AccessList sorted = list; // the kernel wants the entries in the order of their kinds
    if (kind > ACL_GROUP_OBJ) {
        sorted.entries[1] = list.entries[2];
        sorted.entries[2] = list.entries[1];
    }
    const gboolean given = setxattr(path, "system.posix_acl_access", &sorted, sizeof sorted, 0) == 0;
    if (!given) g_test_skip("the file system has no access control lists");
    return given;
}

static void test_named_user(Place *place, gconstpointer data)
{
    g_autofree char *path = install(place, place->first);
    if (!give_list(path, ACL_USER, 4242, 6)) return;
    expect_refused(place, path, "it can be written by the user 4242, whom its access control list names (mode 0764)");
    g_assert_true(give_list(path, ACL_USER, 4242, 4)); // the mask takes it away
    expect_refused(place, path, NULL);
    g_assert_true(give_list(path, ACL_USER, geteuid(), 6));
    expect_refused(place, path, NULL);
}

static void test_named_group(Place *place, gconstpointer data)
{
    const struct passwd *other = getpwnam("daemon");
    if (other == NULL) {
        g_test_skip("there is no account of that name");
        return;
    }
    const gid_t group = other->pw_gid;
    g_autofree char *path = install(place, place->first);
    if (!give_list(path, ACL_GROUP, group, 6)) return;
    g_autofree char *message =
        g_strdup_printf("it can be written by the group %u, which has other members (daemon; mode 0764)", group);
    expect_refused(place, path, message);
    g_assert_true(give_list(path, ACL_GROUP, group, 4));
    expect_refused(place, path, NULL);
}

/* The owning group has another member, and the list lets it read alone: the bit of the mode is the mask's. */
static void test_mask_is_no_group(Place *place, gconstpointer data)
{
    const struct passwd *other = getpwnam("daemon");
    g_autofree char *path = install(place, place->first);
    if (geteuid() != 0 || other == NULL) {
        g_test_skip("only the superuser can give files to groups");
        return;
    }
    g_assert_cmpint(chown(path, (uid_t)-1, other->pw_gid), ==, 0);
    if (give_list(path, ACL_USER, 0, 6)) expect_refused(place, path, NULL);
}

static void test_list_of_folder(Place *place, gconstpointer data)
{
    g_autofree char *path = install(place, place->first);
    if (!give_list(place->first, ACL_USER, 4242, 7)) return;
    expect_refused(place, path,
                   "its folder can be written by the user 4242, whom its access control list names (mode 0774)");
    g_assert_cmpint(removexattr(place->first, "system.posix_acl_access"), ==, 0);
}

static void test_owner(Place *place, gconstpointer data)
{
    if (geteuid() != 0) {
        g_test_skip("only the superuser can give files away");
        return;
    }
    g_autofree char *path = install(place, place->first);
    g_assert_cmpint(chown(path, 4242, (gid_t)-1), ==, 0);
    expect_refused(place, path,
                   "it belongs to the user 4242, not to root, to you (0) or to the owner of this program (0)");
}

int main(int count, char **arguments)
{
    g_test_init(&count, &arguments, NULL);
    add_place_test("/plugin/permissions/file", test_file);
    add_place_test("/plugin/permissions/folder", test_folder);
    add_place_test("/plugin/permissions/folder-above", test_folder_above);
    add_place_test("/plugin/permissions/folder-link", test_folder_link);
    add_place_test("/plugin/permissions/link", test_link);
    add_place_test("/plugin/permissions/link-between", test_link_between);
    add_place_test("/plugin/permissions/owner-of-link", test_owner_of_link);
    add_place_test("/plugin/permissions/manifest", test_manifest);
    add_place_test("/plugin/permissions/reason", test_reason_in_message);
    add_place_test("/plugin/permissions/group", test_group);
    add_place_test("/plugin/permissions/named-user", test_named_user);
    add_place_test("/plugin/permissions/named-group", test_named_group);
    add_place_test("/plugin/permissions/mask-is-no-group", test_mask_is_no_group);
    add_place_test("/plugin/permissions/list-of-folder", test_list_of_folder);
    add_place_test("/plugin/permissions/owner", test_owner);
    return g_test_run();
}
