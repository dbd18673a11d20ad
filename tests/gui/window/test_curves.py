#!/usr/bin/python3
"""Several curves in one graph: added, put to the other axis, taken away; each change is in the file and can be undone."""
import re

from harness import App, check, check_equal, main, mass, scene, wait

GRAVITY = {"type": "gravity", "name": "Gravity"}
GRAPH = {"block": "Ball", "quantity": "y"}


def falling(**more):
    return scene(mass("Ball", 0, 0), mass("Stone", 2, 0), GRAVITY, duration=0.1, graphs=[GRAPH], **more)


def graph(app):
    return app.find(None, re.compile("^Graph of "))


def open_dialog(app):
    x, y, _, _ = app.settled(graph(app))
    app._click_at(x + 40, y + 9)
    app.press("ctrl+l")
    return app.find(None, "Curves of the Graph")


def close_dialog(app):
    app.press("Escape")
    app.gone(None, "Curves of the Graph")
    app.focus_window()


def curves(app):
    found = app.saved()["graphs"][0]
    return found.get("curves") or [{key: found[key] for key in ("block", "quantity")}]


def add_quantity(app, dialog, block, quantity):
    app.choose_from(app.find("combo box", "Block", inside=dialog), block)
    app.choose_from(app.find("combo box", "Quantity", inside=dialog), quantity)
    app.click("Add", inside=dialog)


def test_quantities_of_two_blocks(display):
    with App(display, falling()) as app:
        dialog = open_dialog(app)
        app.click("Add", inside=dialog)  # the first block's first quantity
        app.find("button", re.compile("^Remove Ball.x"), inside=dialog)
        close_dialog(app)
        check_equal([curve.get("quantity") for curve in curves(app)], ["y", "x"], "quantities in the file")
        app.find(None, re.compile("^Graph of Ball: Y Position, Ball: X Position|^Graph of Ball: Y Position, X Position"))
        app.click("Undo")
        check_equal([curve.get("quantity") for curve in curves(app)], ["y"], "quantities after undo")


def test_the_block_of_the_graph_is_chosen(display):
    """It is not the first of the scene."""
    with App(display, scene(GRAVITY, mass("Stone", 2, 0), mass("Ball", 0, 0), duration=0.1, graphs=[GRAPH])) as app:
        app.click("Add", inside=open_dialog(app))
        close_dialog(app)
        check_equal([curve["block"] for curve in curves(app)], ["Ball", "Ball"], "blocks in the file")


def test_more_can_be_added_to_many(display):
    """The list is scrolled; what adds to it stays in sight."""
    many = [{"block": block, "quantity": name} for block in ("Ball", "Stone") for name in ("x", "y", "vx", "vy", "ax", "ay")]
    with App(display, scene(mass("Ball", 0, 0), mass("Stone", 2, 0), graphs=[{"curves": many}])) as app:
        dialog = open_dialog(app)
        _, top, _, height = app.box(dialog)
        for role, name in (("button", "Add"), ("text", "Expression"), ("check box", "Logarithmic Upwards")):
            _, y, _, down = app.settled(app.find(role, name, inside=dialog))
            check(top < y and y + down < top + height, f"{name} from {y} to {y + down} is in the dialog's {height}")


def test_quantities_have_the_names_of_all_lists(display):
    """Titles as in menus, not the names in files."""
    with App(display, falling()) as app:
        dialog = open_dialog(app)
        add_quantity(app, dialog, "Ball", "Y Velocity")
        app.find("button", re.compile("^Remove Ball.vy"), inside=dialog)
        app.click(app.find("combo box", "Quantity", inside=dialog))
        app.press("End", "Return")  # the distances come last, one to each block
        app.click("Add", inside=dialog)
        app.find("button", "Remove Ball.distance to Stone", inside=dialog)
        close_dialog(app)
        check_equal(curves(app)[1]["quantity"], "vy", "quantity in the file")


def test_what_is_measured_stays_with_other_curves(display):
    with App(display, falling()) as app:
        app.click("Play")
        wait(lambda: app.time() == 0.1 and not app.is_playing(), "the end of the run")
        x, y, _, _ = app.settled(graph(app))
        app._click_at(x + 40, y + 9)
        app.press("c")
        wait(lambda: "A: t = 0.1 s" in graph(app).description, "the cursor to be told")
        dialog = open_dialog(app)
        app.click("Add", inside=dialog)
        app.find("button", re.compile("^Remove Ball.x"), inside=dialog)
        close_dialog(app)
        wait(lambda: "A: t = 0.1 s" in graph(app).description, "the cursor to be told still")


def test_table(display):
    """One that holds no numbers is refused with its place; another one lies over the curve."""
    with App(display, falling()) as app:
        (app.home / "words.csv").write_text("t,y\n0,1\n0.1,x\n")
        (app.home / "measured.csv").write_text("t,y\n0,1\n0.1,2\n")
        dialog = open_dialog(app)
        app.click("Add Table…", inside=dialog)
        app.open_dialog("Choose a Table", app.home / "words.csv")
        wait(lambda: app.look("alert", re.compile("words.csv:3:5: the value must be a number"), inside=dialog),
             "what is wrong with it")
        app.focus_window()
        app.click("Add Table…", inside=dialog)
        app.open_dialog("Choose a Table", app.home / "measured.csv")
        app.find("button", "Remove measured.csv: y", inside=dialog)
        close_dialog(app)
        check_equal([curve.get("table") for curve in curves(app)], [None, "measured.csv"], "tables in the file")


def test_columns_of_a_table(display):
    """By their headings, and by keys alone; none over itself."""
    with App(display, falling()) as app:
        (app.home / "track.csv").write_text("frame,t,x,\"y [m]\"\n1,0,7,1\n2,0.1,8,2\n")
        dialog = open_dialog(app)
        app.click("Add Table…", inside=dialog)
        app.open_dialog("Choose a Table", app.home / "track.csv")
        asked = app.find(None, "Columns of the Table")

        def can_be_added():
            return app.look("button", "Add", inside=asked).has("sensitive")

        app.press("shift+Tab", "space", "Down", "Return")  # from the values to the times, and there to "t"
        wait(lambda: not can_be_added(), "no column to be over itself")
        app.press("Tab", "space", "End", "Return")
        wait(can_be_added, "two columns")
        app.press("alt+a")
        app.find("button", "Remove track.csv: y [m]", inside=dialog)
        close_dialog(app)
        added = curves(app)[1]
        check_equal((added["table"], added["time_column"], added["column"]), ("track.csv", 1, 3), "columns in the file")


def test_columns_without_headings(display):
    """Are counted from 1, as a table is read."""
    with App(display, falling()) as app:
        (app.home / "bare.csv").write_text("0,7,1\n0.1,8,2\n")
        dialog = open_dialog(app)
        app.click("Add Table…", inside=dialog)
        app.open_dialog("Choose a Table", app.home / "bare.csv")
        asked = app.find(None, "Columns of the Table")
        app.find(None, "Column 1", inside=asked)
        app.find(None, "Column 2", inside=asked)
        app.press("space", "End", "Return", "alt+a")
        app.find("button", re.compile("^Remove bare.csv"), inside=dialog)
        close_dialog(app)
        check_equal(curves(app)[1]["column"], 2, "the third column in the file")


def test_expression(display):
    with App(display, falling()) as app:
        dialog = open_dialog(app)
        entry = app.find("text", "Expression", inside=dialog)
        app.retype(entry, "{Ball.z}^2")
        app.press("Return")
        wait(lambda: app.look("alert", re.compile("^{Ball.z}: Ball has no quantity.*[.]$", re.DOTALL), inside=dialog),
             "what is wrong with it")
        app.retype(entry, "{Ball.vy}^2")
        app.press("Return")
        app.find("button", "Remove {Ball.vy}^2", inside=dialog)
        wait(lambda: entry.text() == "", "room for another one")
        app.click("Remove Ball.y", inside=dialog)
        wait(lambda: app.look("button", "Remove Ball.y", inside=dialog) is None, "the first curve to go")
        close_dialog(app)
        check_equal([curve.get("expression") for curve in curves(app)], ["{Ball.vy}^2"], "curves in the file")
        app.click("Play")
        wait(lambda: app.time() == 0.1 and not app.is_playing(), "the end of the run")
        # v = -9.81 m/s^2 · 0.1 s
        wait(lambda: "= 0.96236 m" in graph(app).description, "its value")


if __name__ == "__main__":
    main()
