"""The widgets as assistive programs have them: AT-SPI over D-Bus, without its library, whose cache lags behind."""
import collections
import time

from .bus import Bus
from .waiting import Gone

ACCESSIBLE = "org.a11y.atspi.Accessible"
PROGRAM = 75     # the role of what all windows are in
PAUSE = 2        # s, between two times that everybody is asked
IN_WINDOW = 1    # coordinates: those of the screen are not told by GTK 4

STATES = {"checked": 4, "editable": 7, "enabled": 8, "expanded": 10, "focused": 12, "pressed": 20, "selected": 23,
          "sensitive": 24, "visible": 30, "invalid": 36, "read-only": 43}
ROLES = {2: "alert", 7: "check box", 8: "check menu item", 11: "combo box", 16: "dialog", 23: "window", 27: "image", 29: "label",
         31: "list", 32: "list item", 33: "menu", 35: "menu item", 37: "tab", 38: "tab list", 39: "panel",
         42: "progress bar", 43: "button", 44: "radio button", 45: "radio menu item", 48: "scroll bar",
         50: "separator", 51: "slider", 52: "spin button", 61: "text", 62: "toggle button", 69: "window", 79: "entry"}


def plain(name):
    """GTK 4.8 calls a button with a mnemonic “_Close Close”, and an entry of a row “Width Width”."""
    first, second = name[:len(name) // 2].strip(), name[len(name) // 2:].strip()
    return second if first.replace("_", "", 1) == second else name


class Node:
    """One widget. Its name, role and states are those of the moment it was found; everything else is asked for."""

    def __init__(self, tree, item):
        (self.owner, self.path), _, parent, self.index, self.child_count, self.interfaces, self.name, self.role_number, \
            self.description, states = item
        self.tree, self.parent_path = tree, parent[1]
        self.name = plain(self.name)
        self.state_bits = states[0] | states[1] << 32

    @property
    def role(self):
        return ROLES.get(self.role_number, str(self.role_number))

    def has(self, state):
        return bool(self.state_bits >> STATES[state] & 1)

    def refreshed(self):
        """Itself with the name and description of now, or None where it is no more."""
        try:
            self.name = plain(self.get(ACCESSIBLE, "Name"))
            self.description = self.get(ACCESSIBLE, "Description")
            return self
        except Gone:
            return None

    def is_shown(self):
        """Whether it and all that it is in are visible, which GTK 4.8 tells of each only by itself, and it is in a window: a menu
        that has closed can live on for a while without one, next to the windows, and still calls its items visible."""
        chain = [node for node in (self, *self.ancestors()) if node.role_number != PROGRAM]
        return all(node.has("visible") for node in chain) and bool(chain) and chain[-1].role != "menu"

    def __repr__(self):
        return f"{self.role} “{self.name}”"

    def call(self, interface, method, signature="", *values):
        return self.tree.bus.call(self.owner, self.path, interface, method, signature, *values)

    def get(self, interface, name):
        return self.call("org.freedesktop.DBus.Properties", "Get", "ss", interface, name)

    def has_place(self):
        """Pages of a stack, and the program itself, have none."""
        return "org.a11y.atspi.Component" in self.interfaces

    def is_laid_out(self):
        """Pages that were never shown have widgets without a size, or not even that."""
        try:
            return self.has_place() and self.box()[2] > 0
        except Gone:
            return False

    def box(self):
        """(x, y, width, height) within its window."""
        return self.call("org.a11y.atspi.Component", "GetExtents", "u", IN_WINDOW)

    def text(self):
        count = self.get("org.a11y.atspi.Text", "CharacterCount")
        return self.call("org.a11y.atspi.Text", "GetText", "ii", 0, count)

    def value(self):
        return self.get("org.a11y.atspi.Value", "CurrentValue")

    def most(self):
        return self.get("org.a11y.atspi.Value", "MaximumValue")

    def set_value(self, value):
        self.call("org.freedesktop.DBus.Properties", "Set", "ssv", "org.a11y.atspi.Value", "CurrentValue", float(value))

    def parent(self):
        return self.tree.by_path.get(self.parent_path)

    def ancestors(self):
        node = self.parent()
        while node is not None:
            yield node
            node = node.parent()

    def is_inside(self, other):
        return any(node.path == other.path for node in self.ancestors())


class Tree:
    """All widgets of one program at one moment; refresh() takes another moment."""

    def __init__(self, session):
        self.bus = Bus(session.call("org.a11y.Bus", "/org/a11y/bus", "org.a11y.Bus", "GetAddress"))
        self.bus_name = None
        self.nodes, self.by_path = [], {}
        self.asked_all = 0  # when everybody was asked
        self.asked = set()  # (path, children it tells of, children that are listed): in vain

    def find_program(self, process_id):
        """Whether the program is on the bus by now."""
        programs = self.bus.call("org.a11y.atspi.Registry", "/org/a11y/atspi/accessible/root", ACCESSIBLE, "GetChildren")
        for name, _ in programs:
            owner = self.bus.call("org.freedesktop.DBus", "/org/freedesktop/DBus", "org.freedesktop.DBus",
                                  "GetConnectionUnixProcessID", "s", name)
            if owner == process_id:
                self.bus_name = name
        return self.bus_name is not None

    def is_due(self):
        """Whether it was long ago that everybody was asked."""
        return time.monotonic() > self.asked_all + PAUSE

    def refresh(self, thorough=False):
        """Widgets are only listed once their parent was asked for its children: so ask, until there are no more. Whom to
        ask, their numbers tell, but where one came as another went: everybody can be asked, at a price."""
        if thorough:
            self.asked.clear()
            self.asked_all = time.monotonic()
        for _ in range(20):
            items = self.bus.call(self.bus_name, "/org/a11y/atspi/cache", "org.a11y.atspi.Cache", "GetItems")
            self.nodes = [Node(self, item) for item in items]
            self.by_path = {node.path: node for node in self.nodes}
            if not self._ask_for_children(thorough):
                break
        self._put_in_order()
        return self.nodes

    def _put_in_order(self):
        """As they are read: each before what is in it."""
        inside = collections.defaultdict(list)
        for node in self.nodes:
            inside[node.parent_path if node.parent_path in self.by_path else None].append(node)
        for family in inside.values():
            family.sort(key=lambda node: node.index, reverse=True)
        waiting, self.nodes = inside[None], []
        while waiting:
            node = waiting.pop()
            self.nodes.append(node)
            waiting += inside.get(node.path, [])

    def _ask_for_children(self, thorough):
        """Answers whether there are some that were not listed. What these have in them is asked for, too, so that one more list
        has it all: a list of a whole window takes as long as sixty questions."""
        # Those that are hidden by now stay in the list, but are no longer counted by their parent.
        listed = collections.Counter(node.parent_path for node in self.nodes if node.has("visible"))
        found = set()
        for node in self.nodes:
            if node.child_count == listed[node.path] and not (thorough and node.child_count and node.has("visible")):
                continue
            counts = node.path, node.child_count, listed[node.path]
            if counts in self.asked:
                continue
            waiting = self._unlisted_children(node.path, found)
            if not waiting:
                self.asked.add(counts)
            while waiting:
                path = waiting.pop()
                found.add(path)
                waiting += self._unlisted_children(path, found)
        return bool(found)

    def _unlisted_children(self, path, found):
        """Those of a widget that are neither listed nor found by now; none where it is no more."""
        try:
            children = self.bus.call(self.bus_name, path, ACCESSIBLE, "GetChildren")
        except Gone:
            return []
        return [child for _, child in children if child not in self.by_path and child not in found]

    def forget(self):
        self.bus_name = None
        self.nodes, self.by_path = [], {}

    def describe(self):
        """Everything with a name that can be seen, for reports of failures."""
        lines = []
        for node in self.nodes:
            if node.is_shown() and node.name and not node.name.startswith(("Gtk", "Adw")):
                depth = sum(1 for _ in node.ancestors())
                lines.append(f"{'  ' * min(depth, 12)}{node!r}{'' if node.has('sensitive') else ' (insensitive)'}")
        return "\n".join(lines)
