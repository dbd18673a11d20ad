"""The program, started and worked as a user would: by mouse and keys, and by reading what it shows."""
import json
import os
import pathlib
import re
import subprocess
import time

from . import colours, scenes
from .bus import Bus
from .display import end_with_parent
from .keystrokes import Effort
from .tap import Failure, check, keep_picture, say
from .tree import Tree
from .waiting import PATIENCE, Gone, TooLate, wait

PROGRAM = os.environ.get("TINKER_GUI", "tinker-gui")
BUS_NAME = "org.tinker.Tinker"
OBJECT = "/org/tinker/Tinker"
COMPLAINT = re.compile(r"-(WARNING|CRITICAL|ERROR) \*\*|ERROR: \w+Sanitizer|runtime error:")
ITEMS = ("menu item", "check menu item", "radio menu item", "button")
CONTROLS = ("text", "entry", "combo box", "check box", "toggle button")
HANDLE = 16  # pixels about the middle of a slider's handle
VIEW = re.compile(r"Shows (\S+) m by (\S+) m about \((\S+), (\S+)\)")


def _identity(file):
    """What tells a file from one saved in its place."""
    try:
        status = file.stat()
        return status.st_ino, status.st_mtime_ns
    except FileNotFoundError:
        return None


class App:
    """Use with `with`: the program is asked to quit at the end, and must have had nothing to complain about.

    scene: a file, or what is to be in one; None: an empty canvas. home: where the user's files are; None: a new one.
    """

    def __init__(self, display, scene=None, home=None, arguments=(), environment=None):
        self.display = display
        self.home = home or display.new_home()
        self.environment = {**display.environment_of(self.home), **(environment or {})}
        self.file = scene if scene is None or isinstance(scene, os.PathLike) else \
            scenes.write(self.home, "test.tinker.json", scene)
        self.factor = int(self.environment.get("GDK_SCALE", 1))  # pixels on the screen for each that GTK tells of
        self.complaints_file = self.home / "stderr"
        self.process = self._start([PROGRAM, *arguments, *([str(self.file)] if self.file else [])])
        self.session = Bus(display.environment["DBUS_SESSION_BUS_ADDRESS"])
        self.tree = Tree(self.session)
        self.actions_taken = 0
        self.effort = Effort()
        self._kept = {}
        self._was_killed = False

    def _start(self, command):
        with open(self.complaints_file, "ab") as complaints:
            return subprocess.Popen(command, env=self.environment, cwd=self.home, preexec_fn=end_with_parent,
                                    stdin=subprocess.DEVNULL, stdout=complaints, stderr=complaints)

    # Life

    def __enter__(self):
        try:
            self._wait_for_window()
        except BaseException:
            self.kill()
            say(self.complaints())
            raise
        return self

    def _wait_for_window(self):
        def is_there():
            check(self.process.poll() is None, f"the program ended with {self.process.returncode}")
            return self.tree.find_program(self.process.pid) and self.canvas_box()

        wait(is_there, "the window")
        self.focus_window()

    def __exit__(self, kind, error, trace):
        if kind is not None:
            self._report()
            self.kill()
            return
        try:
            if self.process.poll() is None:
                self.quit()
        except BaseException:
            self._report()
            self.kill()
            raise
        self.check_ended_well(killed=self._was_killed)

    def _report(self):
        """What a failure should be read with, while it can still be had."""
        say(self.complaints())
        if self.process.poll() is None:
            keep_picture(self.display)
            say(self._what_is_there())
        self.xdotool("mouseup", 1, "mouseup", 2, "keyup", "ctrl", "keyup", "shift", "keyup", "alt")

    def _what_is_there(self):
        try:
            self.tree.refresh()
        except Gone:
            return "no widgets can be read"
        return self.tree.describe()

    def quit(self):
        """Asks it to; changes are discarded."""
        self.activate("quit", of="app")

        answered = set()

        def has_ended():
            if self.process.poll() is not None:
                return True
            try:
                discard = self.look("button", "Discard")
                if discard and discard.path not in answered:
                    answered.add(discard.path)
                    self._click_at(*self.middle(discard))
            except Gone:
                pass
            return False

        wait(has_ended, "the program to end")

    def check_ended_well(self, killed=False):
        complaints = [line for line in self.complaints().splitlines() if COMPLAINT.search(line)]
        if complaints:
            say(self.complaints())
        check(not complaints, "it complained: " + "\n".join(complaints))
        check(killed or self.process.returncode == 0, f"it ended with {self.process.returncode}\n{self.complaints()}")

    def complaints(self):
        return self.complaints_file.read_text(errors="replace")

    def kill(self):
        """kill -9, as a crash or a power cut would."""
        if self.process.poll() is None:
            self.process.kill()
            self._was_killed = True
        self.process.wait()

    def activate(self, action, *arguments, of="win"):
        """What menus, keys and buttons do, for what a test does not look at by itself."""
        path = OBJECT if of == "app" else f"{OBJECT}/window/1"
        self.session.call(BUS_NAME, path, "org.gtk.Actions", "Activate", "sava{sv}", action, arguments, {})

    def is_enabled(self, action):
        enabled, _, _ = self.session.call(BUS_NAME, f"{OBJECT}/window/1", "org.gtk.Actions", "Describe", "s", action)
        return enabled

    # Finding and reading

    def look(self, role=None, name=None, inside=None, description=None):
        """The first such widget that is shown, or None. `name` may be a compiled pattern."""
        for thorough in (False, True):
            if thorough and not self.tree.is_due():
                break
            for node in self.tree.refresh(thorough):
                if role is not None and node.role != role:
                    continue
                if name is not None and not (name.search(node.name) if hasattr(name, "search") else node.name == name):
                    continue
                if inside is not None and not node.is_inside(inside):
                    continue
                if description is not None and description not in node.description:
                    continue
                if node.is_shown() and node.is_laid_out():
                    return node
        return None

    def find(self, role=None, name=None, inside=None, patience=PATIENCE):
        return wait(lambda: self.look(role, name, inside), f"a {role or 'widget'} “{name}”", patience)

    def gone(self, role=None, name=None):
        wait(lambda: self.look(role, name) is None, f"the {role or 'widget'} “{name}” to go")

    def find_text(self, part):
        """A label that holds this text."""
        return self.find("label", re.compile(re.escape(part)))

    def title(self):
        return self.look("window").name

    # Where things are

    def windows(self):
        """X windows that are shown: {name: (x, y, width, height)}, those of the program in front last."""
        listing = self._xdotool_output("search", "--onlyvisible", "--name", ".", "getwindowgeometry", "--shell", "%@")
        values = [line.split("=")[1] for line in listing.split() if "=" in line]
        found = []
        for start in range(0, len(values) - 5, 6):  # WINDOW, X, Y, WIDTH, HEIGHT, SCREEN
            window, *box = values[start:start + 5]
            if int(box[2]) > 1:
                found.append((window, tuple(map(int, box))))
        return found

    def _native(self, node):
        """(window, dialog or popover that the widget is in, place and size of its X window). A popover is told of with
        its shadow, so that its X window is as large; others without their frame."""
        chain = [other for other in (node, *node.ancestors()) if other.has_place()]
        boxes = [box for _, box in self.windows()]
        for other in chain if len(boxes) > 1 else []:
            outer = self._around(other, boxes, most=0)
            if outer:
                return other, outer
        top = next((other for other in chain if other.role in ("window", "dialog", "alert")), chain[-1])
        return top, self._around(top, boxes, most=120)

    def _around(self, node, boxes, most):
        """The place and size of the X window that is at most so much larger than this."""
        _, _, width, height = (self.factor * value for value in node.box())
        fitting = [(outer[2] - width + outer[3] - height, outer) for outer in boxes
                   if 0 <= outer[2] - width <= most and 0 <= outer[3] - height <= most]
        return min(fitting)[1] if fitting else None

    def box(self, node):
        """(x, y, width, height) on the screen. GTK tells places within the window's contents, which the frame or
        shadow surrounds; of what is in a popover, only places relative to the popover are right."""
        native, outer = self._native(node)
        check(outer, f"no window is as large as {native!r}, {native.box()}: {self.windows()}")
        x, y, width, height = (self.factor * value for value in node.box())
        left, top, across, down = (self.factor * value for value in native.box())
        return (outer[0] + (outer[2] - across) / 2 + x - left, outer[1] + (outer[3] - down) / 2 + y - top, width, height)

    def settled(self, node):
        """Waits until it moves no more, as what slides in does; answers its box on the screen."""
        boxes = [None]

        def stays():
            if self._native(node)[1] is None:
                return False  # what it is in has its place on the screen, but not yet its size
            boxes.append(self.box(node))
            return boxes[-1] == boxes[-2] and boxes[-1][2] > 0

        wait(stays, f"{node!r} to stay in its place")
        return boxes[-1]

    def middle(self, node):
        """Of where it stays."""
        x, y, width, height = self.settled(node)
        return x + width / 2, y + height / 2

    # Mouse and keys

    def xdotool(self, *arguments):
        words = [str(round(word)) if isinstance(word, float) else str(word) for word in arguments]
        self.effort.add(words)
        subprocess.run(["xdotool", *words], env=self.display.environment, check=True, stdout=subprocess.DEVNULL)

    def _xdotool_output(self, *arguments):
        return subprocess.run(["xdotool", *arguments], env=self.display.environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout

    def focus_window(self):
        """There is no window manager that would do it."""
        for window, _ in self.windows():
            self.xdotool("windowfocus", window)

    def _click_at(self, x, y, button=1, keys=()):
        down = [word for key in keys for word in ("keydown", key)]
        up = [word for key in keys for word in ("keyup", key)]
        self.xdotool("mousemove", float(x), float(y), *down, "click", button, *up)

    def click(self, what, role="button", button=1, inside=None):
        """A widget, or the name of one."""
        node = self.find(role, what, inside) if isinstance(what, (str, re.Pattern)) else what
        self.actions_taken += 1
        self._click_at(*self.middle(node), button=button)

    def palette_button(self, title):
        """A block of the palette, scrolled to."""
        button = self.find("button", title)
        _, top, _, height = self.canvas_box()

        def is_inside():
            x, y = self.middle(button)
            if top < y < top + height - 20:
                return True
            self.xdotool("mousemove", float(x), float(top + height / 2), "click", 5 if y > top else 4)
            return False

        wait(is_inside, f"{title} to be scrolled to")
        return button

    def place(self, title):
        """Clicks a block of the palette and waits for it; answers its name."""
        def names():
            return {node.name for node in self.tree.refresh(self.tree.is_due()) if node.role == "list item" and node.is_shown()}

        before, button = names(), self.palette_button(title)
        self.click(button)
        self.xdotool("mousemove", *self.middle(self.canvas()))  # before a tooltip covers the next one
        new = wait(lambda: names() - before, f"a new {title}")
        return new.pop().split(",")[0]

    def press(self, *keys):
        """Keys by their X names, as in ctrl+z; each is an action."""
        self.actions_taken += len(keys)
        self.xdotool("key", *keys)

    def type(self, text):
        self.actions_taken += 1
        self.xdotool("type", "--delay", "1", "--", text)

    # Files

    def saved(self):
        """Saves by key and reads the file, which is another one every time."""
        file = pathlib.Path(self.file)
        before = _identity(file)
        self.xdotool("key", "ctrl+s")
        wait(lambda: _identity(file) not in (None, before), f"{file.name} to be saved")
        return json.loads(file.read_text())

    def blocks(self):
        """What was saved, {name: block}."""
        return {block["name"]: block for block in self.saved()["blocks"]}

    def picture(self):
        return self.display.picture()

    def still_picture(self, *corners):
        """Of an area of the canvas (m), once nothing in it is on its way."""
        last = [None]

        def stays():
            time.sleep(0.2)
            before, last[0] = last[0], self.picture().cut(self.area(*corners))
            return last[0] if last[0] == before else None

        return wait(stays, "a picture that stays as it is")

    # The canvas

    def kept(self, role, name):
        """A widget that stays, found once and asked again: for what is read often."""
        node = self._kept.get((role, name))
        node = node and node.refreshed()
        if node is None:
            node = self._kept[role, name] = self.look(role, name)
        return node

    def canvas(self):
        return wait(lambda: self.kept("image", "Canvas"), "the canvas")

    def canvas_box(self):
        node = self.kept("image", "Canvas")
        return node and VIEW.match(node.description) and self.box(node)

    def view(self):
        """(m from left to right, m from top to bottom, x and y of the middle)."""
        return tuple(float(number) for number in VIEW.match(self.canvas().description).groups())

    def scale(self):
        """Pixels per m."""
        return self.canvas_box()[2] / self.view()[0]

    def at(self, x, y):
        """Where a place of the world is on the screen."""
        left, top, width, height = self.canvas_box()
        across, _, middle_x, middle_y = self.view()
        scale = width / across
        return left + width / 2 + scale * (x - middle_x), top + height / 2 - scale * (y - middle_y)

    def area(self, x0, y0, x1, y1):
        """The box on the screen between two places of the world."""
        (left, bottom), (right, top) = self.at(x0, y0), self.at(x1, y1)
        return left, top, right, bottom

    def reachable(self, x, y):
        """As at(), for a place that has to be free for the pointer."""
        left, top, width, height = self.canvas_box()
        place = self.at(x, y)
        check(left < place[0] < left + width and top < place[1] < top + height - 80,
              f"({x:g}, {y:g}) cannot be reached by the pointer: the test has chosen it badly")
        return place

    def show_width(self):
        """As many metres as the scene says, about (0, 0)."""
        self.activate("zoom-width")
        return self.view()

    def click_world(self, x, y, button=1, keys=()):
        self.actions_taken += 1
        self._click_at(*self.reachable(x, y), button=button, keys=keys)

    def drag_pixels(self, start, *way, keys=(), button=1, release=True):
        """Presses at start, moves on through all points of the way, releases at the last."""
        self.actions_taken += 1
        down = [word for key in keys for word in ("keydown", key)]
        between = [(start[0] + (way[0][0] - start[0]) / 2, start[1] + (way[0][1] - start[1]) / 2), *way]
        self.xdotool("mousemove", *map(float, start), *down, "mousedown", button)
        for x, y in between:
            self.xdotool("mousemove", float(x), float(y))
        if release:
            self.release(keys, button)

    def release(self, keys=(), button=1):
        self.xdotool("mouseup", button, *[word for key in keys for word in ("keyup", key)])

    def drag(self, start, *way, **more):
        """As drag_pixels, between places of the world."""
        self.drag_pixels(self.reachable(*start), *[self.reachable(*place) for place in way], **more)

    def line_count(self, colour, place0, place1):
        """How many pixels of lines of the colour are between two places of the world."""
        return colours.count(self.picture(), self.area(*place0, *place1), colour)

    def fill_count(self, colour, place0, place1):
        return colours.fill_count(self.picture(), self.area(*place0, *place1), colour)

    def middle_of_colour(self, colour, place0, place1):
        """The place of the world that the pixels of lines of the colour lie about."""
        box = self.area(*place0, *place1)
        found = colours.places(self.picture(), box, colour)
        check(found, f"there is nothing of {colour} between {place0} and {place1}")
        x = sum(place[0] for place in found) / len(found)
        y = sum(place[1] for place in found) / len(found)
        (left, bottom), scale = self.at(0, 0), self.scale()
        return (x - left) / scale, (bottom - y) / scale

    def fill_middle(self, colour):
        """The place of the world that areas of the colour lie about, over the whole canvas."""
        left, top, width, height = self.canvas_box()
        box = left, top, left + width, top + height - 80
        picture, near, total, sum_x, sum_y = self.picture(), {}, 0, 0, 0
        for y in range(round(box[1]), round(box[3]), 2):
            for x, pixel in enumerate(picture.pixels((box[0], y, box[2], y + 1)), round(box[0])):
                if pixel not in near:
                    near[pixel] = max(abs(p - c) for p, c in zip(pixel, colour)) <= 3
                if near[pixel]:
                    total, sum_x, sum_y = total + 1, sum_x + x + 0.5, sum_y + y + 0.5
        check(total, f"there is nothing of {colour}")
        (origin_x, origin_y), scale = self.at(0, 0), self.scale()
        return (sum_x / total - origin_x) / scale, (origin_y - sum_y / total) / scale

    def _wait_count(self, count, colour, place0, place1, least, most):
        counts = []

        def holds():
            counts.append(count(colour, place0, place1))
            return least <= counts[-1] <= most

        try:
            wait(holds, "a colour", patience=PATIENCE / 2)
        except TooLate:
            raise Failure(f"{counts[-1]} pixels of {colour} between {place0} and {place1}, "
                          f"expected {least} to {most}") from None

    def wait_lines(self, colour, place0, place1, least=0, most=10**9):
        """Until there are between so many and so many of these pixels."""
        self._wait_count(self.line_count, colour, place0, place1, least, most)

    def wait_fill(self, colour, place0, place1, least=0, most=10**9):
        self._wait_count(self.fill_count, colour, place0, place1, least, most)

    # The panel of properties

    def field(self, group, title):
        """The control of a property: the first of that name behind the heading of its group."""
        def look():
            heading = None
            for node in self.tree.refresh(self.tree.is_due()):
                if node.role == "button" and node.is_shown() and \
                        not any(other.name == "TinkerPropertyField" for other in node.ancestors()):
                    heading = node.name
                elif heading == group and node.name == title and node.role in CONTROLS and node.is_shown():
                    return node
            return None

        return wait(look, f"the property {title} of {group}")

    def read(self, group, title):
        return self.field(group, title).text()

    def wait_read(self, group, title, text):
        read = []

        def holds():
            read.append(self.read(group, title))
            return read[-1] == text

        try:
            wait(holds, text)
        except TooLate:
            raise Failure(f"{title} of {group} reads {read[-1:]}, expected {text!r}") from None

    def enter(self, group, title, text, key="Return"):
        """Types into a property's entry and leaves it by a key."""
        node = self.field(group, title)
        self.bring_into_view(node)
        self._click_at(*self.middle(node))
        wait(lambda: self._has_focus(node), f"{title} to have the focus")
        self._replace_text(text)
        self.xdotool("key", key)
        self.actions_taken += 1

    def _replace_text(self, text):
        self.xdotool("key", "ctrl+a", "key", "BackSpace", *(["type", "--delay", "1", "--", text] if text else []))

    def _has_focus(self, node):
        """An entry itself, or the text in it."""
        return any(other.has("focused") and (other.path == node.path or other.is_inside(node))
                   for other in self.tree.refresh())

    def bring_into_view(self, node):
        """Turns the wheel over what scrolls until the widget is inside of the window."""
        def is_inside():
            _, y, _, height = node.box()
            _, _, _, down = self._native(node)[0].box()
            over = self.look("label", "Outline")
            tabs = self.look("tab", "Properties")
            top = tabs.box()[1] + tabs.box()[3] + 30 if tabs and node.box()[0] >= tabs.box()[0] - 100 else 60
            limit = over.box()[1] if over and node.box()[0] >= over.box()[0] - 20 else down
            if top < y + height / 2 < limit - 8:
                return True
            x, _ = self.middle(node)
            self.xdotool("mousemove", float(x), 300, "click", 5 if y > top else 4)
            return False

        wait(is_inside, f"{node!r} to be scrolled to")

    def save_dialog(self, title, file):
        """Answers a dialog that asks for the name of a file. It is there before its entry takes keys, and looks into the folder
        of what is typed: each thing is done when the one before it can be seen."""
        dialog = self.find(None, title)

        def entry():
            node = self.look("text", re.compile("^Name"), inside=dialog)
            return node if node and node.has("focused") else None

        wait(entry, f"the entry of “{title}” to have the focus")
        self.xdotool("key", "ctrl+a")
        self.xdotool("type", "--delay", "1", str(file))
        wait(lambda: entry().text() == str(file), f"{file} to be typed")
        self.actions_taken += 1
        self._press_until_gone(title)

    def _press_until_gone(self, title):
        """A Return that comes while the dialog looks into the folder is lost."""
        def is_answered():
            if self.look(None, title) is None:
                return True
            if time.monotonic() > pressed[0] + 2:
                self.xdotool("key", "Return")
                pressed[0] = time.monotonic()
            return False

        self.xdotool("key", "Return")
        pressed = [time.monotonic()]
        wait(is_answered, f"“{title}” to be answered")

    def open_dialog(self, title, file):
        """Answers a dialog that asks for a file that there is. It looks into the folder of what is typed, and a key that comes
        meanwhile is lost: Return is pressed again where the dialog is still there long after."""
        self.find(None, title)
        self.xdotool("type", "--delay", "1", "--", str(file))
        self.actions_taken += 1
        self._press_until_gone(title)

    # Running

    def time(self):
        """Of the play-back, as shown (s)."""
        return float(wait(lambda: self.kept("text", "Time"), "the time").text().split()[0])

    def is_playing(self):
        return self.look("button", "Pause") is not None

    def seek(self, share):
        """Presses on the time line, and waits until something else is shown; answers the time."""
        line = self.find("slider", "Time line")
        x, y, width, height = self.settled(line)
        now = line.value() / line.most()
        if abs(share - now) * width < HANDLE:  # which would be taken, and stay
            self._seek(x + (0.03 if now > 0.25 else 0.97) * width, y + height / 2)
        self._seek(x + share * width, y + height / 2)
        return self.time()

    def _seek(self, x, y):
        before = self.time()
        self._click_at(x, y)
        self.actions_taken += 1
        wait(lambda: self.time() != before, "another time")

    # Menus, lists and the like

    @staticmethod
    def pattern(text):
        return re.compile(text)

    def find_starting(self, role, start):
        return self.find(role, re.compile("^" + re.escape(start)))

    def find_item(self, name):
        """An item of the menu that is open."""
        return wait(lambda: next((node for role in ITEMS if (node := self.look(role, name))), None), f"the item “{name}”")

    def choose(self, *names):
        """Clicks through a menu that is open; with opening it, this is one action."""
        for name in names:
            item = self.find_item(name)
            self._click_at(*self.middle(item))

    def choose_in(self, group, title, name):
        self.choose_from(self.field(group, title), name)

    def choose_from(self, drop_down, name):
        """Opens a drop-down list and clicks an entry of it."""
        self.bring_into_view(drop_down)
        self.click(drop_down)
        self.click(self.find("label", name))

    def retype(self, entry, text):
        """Puts another text into an entry."""
        self._click_at(*self.middle(entry))
        self._replace_text(text)
        self.actions_taken += 1

    def outline_item(self, name):
        """What the outline says of a body."""
        return self.find("list item", re.compile("^" + re.escape(name) + ", .* at "))

    def click_block(self, name, button=1, keys=()):
        """A body, on the canvas, where the outline says that it is."""
        x, y = (float(number) for number in re.search(r"at \((\S+) m, (\S+) m\)", self.outline_item(name).name).groups())
        self.click_world(x + 0.13, y + 0.13, button=button, keys=keys)

    def right_click_graph(self):
        self.click(self.find(None, re.compile("^Graph of ")), button=3)
