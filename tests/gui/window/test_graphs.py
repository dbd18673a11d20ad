#!/usr/bin/python3
"""Graphs: added, moved, sized, deleted, copied, saved as pictures and tables."""
import csv
import os
import subprocess

from harness import App, check, check_close, check_equal, colours, main, mass, scene, spring, support, wait
from harness.scenes import connector

CLIPBOARD = os.environ["TINKER_CLIPBOARD"]  # another program, which reads the clipboard

GRAVITY = {"type": "gravity", "name": "Gravity"}


def falling(*graphs, **more):
    return scene(mass("Ball", 0, 0), GRAVITY, duration=0.1, graphs=list(graphs), **more)


DOCKED = {"block": "Ball", "quantity": "y"}
FLOATING = {"block": "Ball", "quantity": "y", "place": [-4.5, 4], "size": [3, 2]}


def graph(app):
    return app.find(None, app.pattern("^Graph of "))


def run(app):
    app.click("Play")
    wait(lambda: app.time() == 0.1 and not app.is_playing(), "the end of the run")


def test_few_quantities_are_in_one_menu(display):
    """A bumper has four quantities, of which a record has the force of its own accord."""
    file = scene(support("Floor", 0, 0), mass("Ball", 2, 2), connector("bumper", "Buffer", "Floor", "Ball"))
    with App(display, file) as app:
        app.click(app.find("list item", app.pattern("^Buffer")), button=3)
        app.choose("Add Graph", "Compression")
        graph(app)
        check_equal(app.saved()["graphs"][0]["quantity"], "compression", "quantity of the graph in the file")


def test_page_offers_what_moves(display):
    """Whichever block comes first, and whatever an empty canvas had to offer before."""
    with App(display, scene(GRAVITY, support("Floor", 0, -3), mass("Ball", 0, 0), duration=0.1)) as app:
        app.click("Graphs", role="tab")
        app.click("Add Graph")
        check_equal(app.saved()["graphs"][0]["block"], "Ball", "block of the graph in the file")


def test_menu_of_a_block_adds_one(display):
    with App(display, falling()) as app:
        app.show_width()
        app.click_world(0.2, 0.2, button=3)
        app.choose("Add Graph", "Y Position")
        graph(app)
        check_equal(app.saved()["graphs"][0]["block"], "Ball", "block of the graph in the file")
        app.click("Undo")
        check_equal(app.saved().get("graphs", []), [], "graphs after undo")


def test_new_graph_is_in_front(display):
    """Another one covers all but a strip on the left: there is no free room for a new one. What lies in front takes clicks."""
    large = {"block": "Ball", "quantity": "y", "place": [-3.4, 6], "size": [20, 20]}
    with App(display, scene(mass("Ball", -4.2, 0), GRAVITY, duration=0.1, graphs=[large])) as app:
        app.show_width()
        app.click_world(-4.1, 0.1, button=3)
        app.choose("Add Graph", "X Position")
        new = app.find(None, app.pattern("^Graph of .*X Position"))
        left, top, right, bottom = app.canvas_box()
        x, y, width, height = app.settled(new)
        check(left <= x and top <= y and x + width <= left + right and y + height <= top + bottom, "it is on the canvas")
        app.click(new, button=3)
        app.choose("Delete Graph")
        check_equal([each["quantity"] for each in app.saved()["graphs"]], ["y"], "graphs without the one in front")


def test_new_graph_covers_no_block(display):
    """A wide support lies where a graph would come first."""
    with App(display, scene(support("Roof", 2.5, 2.4, width=4, height=0.4), mass("Ball", 0, 0), GRAVITY)) as app:
        app.show_width()
        app.click_world(0.2, 0.2, button=3)
        app.choose("Add Graph", "Y Position")
        x, y, width, height = app.settled(graph(app))
        for left, top, right, bottom in (app.area(0.5, 2.2, 4.5, 2.6), app.area(-0.4, -0.4, 0.4, 0.4)):
            check(x + width <= left or right <= x or y + height <= top or bottom <= y,
                  f"the graph {(x, y, width, height)} covers {(left, top, right, bottom)}")


def clipboard_picture(app):
    """(width, height, rows of bytes), as another program gets it."""
    file = app.home / "clipboard.ppm"
    subprocess.run([CLIPBOARD, str(file)], env=app.environment, check=True, timeout=60)
    kind, size, most, pixels = file.read_bytes().split(b"\n", 3)
    check_equal((kind, most), (b"P6", b"255"), "kind of file")
    width, height = map(int, size.split())
    return width, height, [pixels[3 * width * y:3 * width * (y + 1)] for y in range(height)]


def test_picture_on_the_clipboard(display):
    """The curve of a fall: from the upper left to the lower right, on white paper, twice as fine as on the screen."""
    with App(display, falling(FLOATING)) as app:
        app.show_width()
        run(app)
        _, _, across, down = app.box(graph(app))
        app.click(graph(app), button=3)
        app.choose("Copy")
        width, height, rows = clipboard_picture(app)
        check_close(width, 2 * across, 8, "width (pixels)")
        check(down < height <= 2 * down, f"height {height} of a graph of {down} pixels on the screen")
        check_equal(rows[0][:3], b"\xff\xff\xff", "paper")
        on_curve = [(x, y) for y, row in enumerate(rows) for x in range(width)
                    if tuple(row[3 * x:3 * x + 3]) == colours.CURVE]
        check(len(on_curve) > width / 4, f"{len(on_curve)} pixels of a curve")
        first, last = min(on_curve), max(on_curve)
        check(last[0] - first[0] > width / 2, "the curve goes from left to right")
        check(last[1] - first[1] > height / 4, "and down, below the title")


def test_pointer_reads_the_curve(display):
    """Only near the curve, and not where it is not wished. What it reads is tested where the words are made."""
    with App(display, falling({**FLOATING, "size": [5, 4]})) as app:
        app.show_width()
        run(app)
        x, y, width, height = app.settled(graph(app))
        inside = x + 4, y + 40, x + width - 4, y + height - 24
        away = inside[0] + 0.8 * (inside[2] - inside[0]), inside[1] + 30  # the fall is far below there
        app.xdotool("mousemove", *away)
        curve = wait(lambda: colours.places(app.picture(), inside, colours.CURVE, least=0.95, most=1.05), "the curve")
        middle = min(curve, key=lambda place: abs(place[0] - (x + width / 2)))
        check(middle[1] > away[1] + 60 or abs(middle[0] - away[0]) > 60, "a place that is far from the curve")
        plain = app.picture().cut(inside)
        app.xdotool("mousemove", *middle)
        wait(lambda: app.picture().cut(inside) != plain, "values at the curve")
        app.xdotool("mousemove", *away)
        wait(lambda: app.picture().cut(inside) == plain, "them to go away from it")
        app.click(graph(app), button=3)
        app.choose("Show Point Values")
        wait(lambda: len(app.windows()) == 1, "the menu to go")  # GTK complains of questions about one that is gone
        app.xdotool("mousemove", *middle)
        wait(lambda: app.picture().cut(inside) == plain, "nothing, once it is off")


def test_menu_of_a_graph(display):
    with App(display, falling(DOCKED)) as app:
        app.click(graph(app), button=3)
        for item in ("Copy", "Save Image As…", "Show Point Values", "Export Values To File…"):
            app.find_item(item)
        app.press("Escape")


def test_spectrum_and_phase_portrait(display):
    """sqrt(25) / 2 pi = 0.796 Hz: of 5 s the line at 0.8 Hz is the greatest."""
    swing = scene(support("Wall", 0, 3), mass("Ball", 0, 0.5), spring("K", "Wall", "Ball", stiffness=25, rest_length=2),
                  duration=5, graphs=[DOCKED])
    with App(display, swing) as app:
        app.click("Play")
        wait(lambda: app.time() == 5 and not app.is_playing(), "the end of the run")
        app.click(graph(app), button=3)
        app.choose("Over", "Frequency (Spectrum)")
        app.find(None, "Graph of Spectrum of Ball: Y Position")
        check_equal(app.saved()["graphs"][0]["against"], "frequency", "what it is over, in the file")
        wait(lambda: graph(app).description.startswith("f = 0.8 Hz, y = 0."), "the greatest amplitude to be told")
        app.click(graph(app), button=3)
        app.choose("Over", "Y Velocity")
        app.find(None, "Graph of Ball: Y Position over Y Velocity")
        app.click(graph(app), button=3)
        app.choose("Over", "Time")
        app.find(None, "Graph of Ball: Y Position")
        check_equal("against" in app.saved()["graphs"][0], False, "something that it is over, in the file")


def test_export_of_a_fall(display):
    """The table of the thesis: y = -9.81 t²/2 every 0.01 s, to five decimals."""
    with App(display, falling(DOCKED)) as app:
        run(app)
        app.click(graph(app), button=3)
        app.choose("Export Values To File…")
        file = app.home / "fall.csv"
        app.save_dialog("Export Values To File", file)
        wait(file.exists, "the file")
        with open(file, newline="") as opened:
            head, *rows = csv.reader(opened)
        check_equal(head, ["Time", "Y Position"], "head of the table")
        check_equal(len(rows), 11, "rows")
        shown = [-0.00049, -0.00196, -0.00441, -0.00785, -0.01226, -0.01766, -0.02403, -0.03139, -0.03973, -0.04905]
        for number, (time, y) in enumerate(rows):
            check_close(float(time), 0.01 * number, 1e-9, "time")
            check_close(float(y), -9.81 * float(time) ** 2 / 2, 1e-8, f"y at {time} s")
            if number > 0:
                check_equal(round(float(y), 5), shown[number - 1], f"y at {time} s as the thesis has it")


def test_export_before_a_run_says_what_to_do(display):
    with App(display, falling(DOCKED)) as app:
        app.click(graph(app), button=3)
        app.choose("Export Values To File…")
        app.click("Close", inside=app.find("dialog", "Nothing to Export Yet"))


def test_image_is_saved(display):
    with App(display, falling(DOCKED)) as app:
        run(app)
        for ending, start in ((".png", b"\x89PNG"), (".svg", b"<?xml"), (".pdf", b"%PDF")):
            app.click(graph(app), button=3)
            app.choose("Save Image As…")
            file = app.home / f"fall{ending}"
            app.save_dialog("Save Image As", file)
            wait(lambda: file.exists() and file.stat().st_size > 500, f"the file {file.name}")
            check(file.read_bytes().startswith(start), f"{file.name} is what its ending says")
            app.gone(None, "Save Image As")


def test_graph_is_deleted_and_comes_back(display):
    with App(display, falling(DOCKED)) as app:
        app.click(graph(app), button=3)
        app.choose("Delete Graph")
        check_equal(app.saved().get("graphs", []), [], "graphs in the file")
        app.click("Undo")
        graph(app)


def test_floating_graph_is_where_it_was_saved(display):
    with App(display, falling(FLOATING)) as app:
        app.show_width()
        x, y, width, height = app.box(graph(app))
        left, top = app.at(-4.5, 4)
        check_close(x, left, 3, "left edge (pixels)")
        check_close(y, top, 3, "upper edge (pixels)")
        check_close(width, 3 * app.scale(), 6, "width (pixels)")
        check_close(height, 2 * app.scale(), 6, "height (pixels)")


def test_floating_graph_is_moved_by_its_title(display):
    with App(display, falling(FLOATING)) as app:
        app.show_width()
        x, y, width, height = app.box(graph(app))
        start = x + width / 3, y + 10
        app.drag_pixels(start, (start[0] + app.scale(), start[1] + app.scale()))
        place = app.saved()["graphs"][0]["place"]
        check_close(place[0], -3.5, 0.11, "x")
        check_close(place[1], 3, 0.11, "y")


def test_floating_graph_is_sized_by_its_corner(display):
    with App(display, falling(FLOATING)) as app:
        app.show_width()
        x, y, width, height = app.box(graph(app))
        corner = x + width - 5, y + height - 5
        app.drag_pixels(corner, (corner[0] + app.scale(), corner[1] + app.scale()))
        size = app.saved()["graphs"][0]["size"]
        check_close(size[0], 4, 0.11, "width")
        check_close(size[1], 3, 0.11, "height")


def test_graph_that_is_floated_stays_inside(display):
    """The canvas of a tall scene becomes taller as the graph leaves the dock, and what is on it larger."""
    tower = [mass(f"M{i}", 0, 3 * i) for i in range(6)]
    with App(display, scene(*tower, width=4, duration=0.1, graphs=[{"block": "M0", "quantity": "y"}])) as app:
        app.activate("zoom-fit")
        low = app.canvas_box()[3]
        app.click("Float on the Canvas")
        wait(lambda: app.canvas_box()[3] > low, "the canvas to become taller")
        app.find("button", "Dock Below the Canvas")
        x, y, width, height = app.settled(graph(app))
        left, top, across, down = app.canvas_box()
        check(left <= x and x + width <= left + across and top <= y and y + height <= top + down,
              f"the graph, {width} x {height} at ({x}, {y}), is inside of the canvas, {across} x {down} at ({left}, {top})")
        for number in range(6):
            place = app.at(0, 3 * number)
            check(not (x <= place[0] <= x + width and y <= place[1] <= y + height), f"M{number} is not covered")


if __name__ == "__main__":
    main()
