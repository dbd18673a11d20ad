#!/usr/bin/python3
"""What graphs, runs beside one another, meters and hands have in common with a laboratory: each is held to a closed form.
Motion at 1 m/s without gravity is at x = -2 + t; a mass of 1 kg on 25 N/m swings with 5 rad/s."""
import csv
import math
import os
import re
import subprocess

from harness import App, check, check_close, check_equal, colours, main, mass, scene, spring, support, wait
from harness.scenes import connector

X = {"block": "Ball", "quantity": "x"}
GERMAN = "de_DE.UTF-8"


def keep(app, name):
    folder = os.environ.get("TINKER_PICTURES")
    if folder:
        app.picture().write_png(f"{folder}/{name}.png")


def sliding(**more):
    return scene(mass("Ball", -2, 0, velocity=[1, 0]), **{"duration": 0.5, "graphs": [X], **more})


def oscillator(**more):
    return scene(support("Roof", 0, 4, orientation="180 deg"), mass("Bob", 0, 1, mass=1),
                 spring("Coil", "Roof", "Bob", stiffness=25, rest_length=2), duration=4, **more)


def run(app, duration):
    app.click("Play")
    wait(lambda: app.time() == duration and not app.is_playing(), "the end of the run")


def graph(app):
    return app.find(None, re.compile("^Graph of "))


def focus_graph(app):
    x, y, _, _ = app.settled(graph(app))
    app._click_at(x + 40, y + 9)


def test_second_axis_and_logarithms(display):
    """By keys and lists of the dialog; what is chosen is in the file, and seen."""
    curves = [{"block": "Ball", "quantity": "x"}, {"block": "Ball", "quantity": "vx"}]
    with App(display, sliding(graphs=[{"curves": curves}])) as app:
        run(app, 0.5)
        app.xdotool("mousemove", 5, 5)
        x, y, width, height = app.settled(graph(app))
        right = (x + width - 60, y + 30, x + width, y + height)
        plain = app.picture().cut(right)
        focus_graph(app)
        app.press("ctrl+l")
        dialog = app.find(None, "Curves of the Graph")
        app.choose_from(app.find("combo box", "Axis of Ball.vx", inside=dialog), "Right Axis")
        app.click("Logarithmic Across", role="check box", inside=dialog)
        app.press("Escape")
        app.gone(None, "Curves of the Graph")
        app.focus_window()
        wait(lambda: app.saved()["graphs"][0].get("scale") == ["log", "linear"], "the scale in the file")
        check_equal([curve.get("axis", 1) for curve in app.saved()["graphs"][0]["curves"]], [1, 2], "axes in the file")
        app.xdotool("mousemove", 5, 5)
        wait(lambda: app.picture().cut(right) != plain, "an axis on the right")
        keep(app, "axes")


def test_table_over_the_curve_is_drawn(display):
    """Measured values lie on the line x = -2 + t, from one to the next."""
    with App(display, sliding()) as app:
        (app.home / "measured.csv").write_text("t,x\n0,-2\n0.2,-1.8\n0.5,-1.5\n")
        run(app, 0.5)
        focus_graph(app)
        app.press("ctrl+l")
        dialog = app.find(None, "Curves of the Graph")
        app.click("Add Table…", inside=dialog)
        app.open_dialog("Choose a Table", app.home / "measured.csv")
        app.find("button", "Remove measured.csv: x", inside=dialog)
        app.press("Escape")
        app.gone(None, "Curves of the Graph")
        app.focus_window()
        focus_graph(app)
        app.press("s")
        text = wait(lambda: app.look("label", re.compile("Root mean square of the differences from “measured.csv: x”, 3 values")),
                    "how well the run fits it").name
        off = float(re.search(r"differences from “measured.csv: x”, 3 values = (\S+)", text).group(1))
        check(off < 1e-12, f"the run is {off} m off what lies on its line")
        app.click("Close", inside=app.find(None, "Statistics"))


def keep_and_go_faster(app):
    app.press("ctrl+k")
    app.find_text("Kept as “Run 1”")
    app.click_block("Ball")
    app.enter("Initial Velocity", "Vx", "2")
    run(app, 0.5)


def test_eight_runs_and_their_ghosts(display):
    """The ninth says what to do; a ghost is seen where its own run is, half a metre behind, and goes with it."""
    with App(display, sliding(width=8)) as app:
        app.show_width()
        run(app, 0.5)
        keep_and_go_faster(app)
        app.xdotool("mousemove", 5, 5)
        behind = -2, -0.5, -1.5, 0.5  # what the ghost covers alone: it is at -1.5, the body at -1, 0.4 to each side
        ghost = app.still_picture(*behind)
        app.press("ctrl+shift+k")
        dialog = app.find(None, "Kept Runs")
        app.click(re.compile("^Show Ball"), role="check box", inside=dialog)
        app.press("Escape")
        app.gone(None, "Kept Runs")
        app.focus_window()
        app.xdotool("mousemove", 5, 5)
        wait(lambda: app.still_picture(*behind) != ghost, "the ghost to go")
        for _ in range(7):
            app.press("ctrl+k")
        app.press("ctrl+k")
        app.find_text("Eight runs are kept: remove one first")


def test_kept_runs_are_exported(display):
    """Each has columns of its own beside the present run's, named by what was changed."""
    with App(display, sliding()) as app:
        run(app, 0.5)
        keep_and_go_faster(app)
        app.click(graph(app), button=3)
        app.choose("Export Values To File…")
        file = app.home / "runs.csv"
        app.save_dialog("Export Values To File", file)
        wait(file.exists, "the file")
        with open(file, newline="") as opened:
            head, *rows = csv.reader(opened)
        check("Vx 1 m/s" in head[-1], f"the kept run's name in {head}")
        for row in rows:
            time = float(row[0])
            check_close(float(row[1]), -2 + 2 * time, 1e-9, "the present run (m)")
            check_close(float(row[-1]), -2 + float(row[-2]), 1e-9, "the kept one (m)")


def test_meters_as_dial_and_bar(display):
    """All three tell the same value, 2 - cos(5 t), and look different."""
    meters = [{"block": "Bob", "quantity": "y", "kind": kind, "place": [x, 3.5]}
              for kind, x in (("number", -4.8), ("dial", -2.6), ("bar", 1.2))]
    with App(display, oscillator(meters=meters)) as app:
        app.show_width()
        app.click("Play")
        wait(lambda: app.time() == 4 and not app.is_playing(), "the end of the run")
        nodes = [node for node in app.tree.refresh() if node.name == "Meter of Bob: Y Position"]
        check_equal(len(nodes), 3, "meters")
        for node in nodes:
            value = float(re.match(r"(\S+) m$", node.refreshed().description).group(1))
            check_close(value, 2 - math.cos(20), 1e-3, "what it tells (m)")
        keep(app, "meters")
        app.xdotool("mousemove", 5, 5)
        dial, bar = (app.settled(node) for node in nodes[1:])
        before = [app.picture().cut((x, y + 20, x + width, y + height)) for x, y, width, height in (dial, bar)]
        app.seek(0.157)  # half a swing: at the other end
        for (x, y, width, height), picture in zip((dial, bar), before):
            wait(lambda: app.picture().cut((x, y + 20, x + width, y + height)) != picture, "its hand to move")


def test_runs_a_second_are_told_where_they_are_few(display):
    """Of a chain of a hundred masses, and of sixty discs that collide."""
    links = [mass(f"M{i}", 0.8 * i - 40, 3, width=0.4, height=0.4) for i in range(100)]
    springs = [spring(f"S{i}", f"M{i}", f"M{i + 1}", stiffness=4000, rest_length=0.7) for i in range(99)]
    balls = [{"type": "disc", "name": f"D{i}", "radius": 0.3, "position": [0.65 * i - 30, 0.5 + 0.4 * (i % 3)], "solid": True,
              "restitution": 0.5} for i in range(60)]
    control = {"block": "S0", "property": "stiffness", "from": 1000, "to": 8000, "kind": "slider", "place": [-30, 20]}
    with App(display, scene(support("Floor", 0, -1, width=200), *links, *springs, *balls, {"type": "gravity", "name": "Gravity"},
                            width=100, duration=10, controls=[control])) as app:
        slider = app.find("slider", "S0: K")
        x, y, width, height = app.settled(slider)
        app.xdotool("mousemove", x + 0.43 * width, y + height / 2, "mousedown", 1)

        def told():
            for share in (0.5, 0.6, 0.7, 0.6):
                app.xdotool("mousemove", x + share * width, y + height / 2)
            return app.look("label", re.compile(r"^\d+ runs a second$"))

        text = wait(told, "how many runs a second there are").name
        app.xdotool("mouseup", 1)
        check(1 <= int(text.split()[0]) < 20, text)


def test_pull_is_in_the_books(display):
    """A hand takes a body along: it is a force of the diagram, and work in the books, under its own name."""
    blocks = (mass("Ball", 0, 0, mass=1), connector("hand", "Hand", "Ball", place=[0, 1.6], pulls=True, damping=10))
    with App(display, scene(*blocks, duration=60)) as app:
        app.show_width()
        app.click_world(0, 1.0)
        app.click("Play")
        wait(lambda: app.time() > 0.2, "time to pass")
        app.drag((0, 1.6), (3, 1.6))
        before = app.time()
        wait(lambda: app.time() > before + 0.3, "the hand to have pulled")
        app.press("space")
        wait(lambda: not app.is_playing(), "the pause")
        app.click(app.find_starting("list item", "Ball, Mass"))
        app.click("Equations", role="tab")
        books = app.find("image", "Work and energy, impulse and momentum")
        app.bring_into_view(books)
        app.click(books)
        for _ in range(8):
            app.press("Down")
            if "Hand" in (books.refreshed().description or ""):
                break
        check("Hand" in books.description, f"the books tell of {books.description}")
        keep(app, "pulled")


def test_written_larger_for_a_projector(display):
    """What stands before the time in the play bar, for one, and the scale of a dial."""
    dial = {"block": "Bob", "quantity": "y", "kind": "dial", "place": [-4.8, 3.5]}
    with App(display, oscillator(meters=[dial])) as app:
        def sizes():
            return [app.settled(app.find(None, name))[2] for name in ("t =", "Meter of Bob: Y Position")]

        before = sizes()
        app.press("F11")
        wait(lambda: all(now > 1.3 * size for now, size in zip(sizes(), before)), "both to be larger")
        keep(app, "projector")
        app.press("Escape")
        wait(lambda: sizes() == before, "them to be as they were")


def german(app_home):
    """The locale is compiled here: gettext translates nothing where it is C."""
    folder = app_home / "locale"
    folder.mkdir()
    subprocess.run(["localedef", "--quiet", "-i", "de_DE", "-f", "UTF-8", str(folder / GERMAN)], check=True)
    return {"LOCPATH": str(folder), "LC_ALL": GERMAN, "LANG": GERMAN}


def translated():
    """Of the catalogue: English texts of one line whose German is another."""
    text = (os.path.dirname(os.path.abspath(__file__)) + "/../../../host/po/de.po")
    with open(text, encoding="utf-8") as opened:
        pairs = re.findall(r'^msgid "(.+)"\nmsgstr "(.+)"$', opened.read(), re.M)
    return {english.replace("_", ""): german.replace("_", "") for english, german in pairs if english != german}


class GermanApp(App):
    """Its canvas has another name."""

    def canvas_box(self):
        node = self.kept("image", translated()["Canvas"])
        return node and self.box(node)


def test_all_of_it_in_german(display):
    """Nothing that has another text in German is called by its English one: instruments, graph, its dialog and its menu."""
    home = display.new_home()
    control = {"block": "Coil", "property": "stiffness", "from": 0, "to": 100, "kind": "slider", "place": [-4.5, 2]}
    meter = {"block": "Bob", "quantity": "y", "kind": "dial", "place": [2, 2]}
    content = oscillator(controls=[control], meters=[meter], graphs=[{"block": "Bob", "quantity": "y"}])
    words = translated()
    with GermanApp(display, content, home=home, environment=german(home)) as app:
        def check_german(where):
            for node in app.tree.refresh():
                if node.is_shown() and node.name in words:
                    check(False, f"{where}: “{node.name}” is “{words[node.name]}” in German")

        app.find("slider", re.compile("^Coil: "))
        app.press("space")
        wait(lambda: app.look("button", "Pause"), "the button that pauses")
        check_german("window")
        keep(app, "german")
        node = app.find(None, re.compile("^" + words["Graph of %s"].replace("%s", "")))
        x, y, _, _ = app.settled(node)
        app._click_at(x + 40, y + 9)
        app.press("ctrl+l")
        app.find(None, words["Curves of the Graph"])
        check_german("curves")
        keep(app, "german-curves")
        app.press("Escape")
        app.gone(None, words["Curves of the Graph"])


if __name__ == "__main__":
    main()
