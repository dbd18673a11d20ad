#!/usr/bin/python3
"""Graphs: added, moved, sized, deleted, copied, saved as pictures and tables."""
import csv
import subprocess

from harness import App, check, check_close, check_equal, main, mass, scene, wait

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


def test_menu_of_a_block_adds_one(display):
    with App(display, falling()) as app:
        app.show_width()
        app.click_world(0.2, 0.2, button=3)
        app.choose("Add Graph", "Y Position")
        graph(app)
        check_equal(app.saved()["graphs"][0]["block"], "Ball", "block of the graph in the file")
        app.click("Undo")
        check_equal(app.saved().get("graphs", []), [], "graphs after undo")


def test_menu_of_a_graph(display):
    with App(display, falling(DOCKED)) as app:
        app.click(graph(app), button=3)
        for item in ("Copy", "Save Image As…", "Show Point Values", "Export Values To File…"):
            app.find_item(item)
        app.press("Escape")


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


if __name__ == "__main__":
    main()
