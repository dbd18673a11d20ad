#!/usr/bin/python3
"""Where the parts of the window are: what comes and goes moves nothing, and there is room for what matters."""
import json
import pathlib
import re

from harness import App, check, check_equal, main, mass, scene, spring, support, wait
from harness import colours

BODY_EDGE = (0x27, 0x49, 0x6d)
LONG = "Supercalifragilistic" * 12
GRAVITY = {"type": "gravity", "name": "Gravity"}


def width_of_window(app):
    return max(box[2] for _, box in app.windows())


def test_notice_moves_nothing(display):
    with App(display, scene(support("Floor", 0, 0), mass("Box", 0, 2))) as app:
        palette = app.settled(app.find("button", "Rod"))
        canvas, view = app.canvas_box(), app.view()
        app.click_world(0.2, 2.2)
        app.enter("Global Position", "Y", "0.3")  # into the support
        app.find("button", re.compile("^Box starts .* below the top of Floor"))
        check_equal(app.settled(app.find("button", "Rod")), palette, "place of a button of the palette")
        check_equal(app.canvas_box(), canvas, "place of the canvas")
        check_equal(app.view(), view, "what the canvas shows")
        check(app.find("slider", "Time line").box()[2] > 0, "the play bar is there")


def test_notice_is_about_nothing_beneath_it(display):
    """The scene is first shown below the place of a notice."""
    with App(display, scene(support("Floor", 0, -0.5), mass("Box", 0, -0.4), mass("High", 0, 5), width=4)) as app:
        notice = app.settled(app.find("button", re.compile("^Box starts ")))
        check(app.at(0, 5.4)[1] > notice[1] + notice[3], "the highest block is below the notice")


def test_field_is_not_beneath_a_notice(display):
    """Its arrow goes down for the notice, where a click finds it, and back up once that is closed."""
    with App(display, scene(GRAVITY, support("Floor", 0, 0), mass("Box", 0, 0.3))) as app:
        notice = app.settled(app.find("button", re.compile("^Box starts ")))
        left, top, _, _ = app.canvas_box()
        app._click_at(left + 30, notice[1] + notice[3] + 40)
        app.wait_read("Appearance", "Name", "Gravity")
        app.click("Close Notice")
        app.click_world(3, -2)
        app.gone("text", "Name")
        app._click_at(left + 30, top + 40)
        app.wait_read("Appearance", "Name", "Gravity")


def test_notice_in_a_small_window(display):
    """At 800 by 500 pixels, the least there may be: its text is no column of letters, and its buttons are inside."""
    with App(display, scene(support("Floor", 0, 0), mass("Box", 0, 0.3), spring("Link", (-2, 3), (2, 3)))) as app:
        make_small(app)
        left, top, width, height = app.canvas_box()
        text = app.settled(app.find("button", re.compile("^Box starts ")))
        check(text[2] > 200 and text[3] < height / 3, f"the text of the notice is {text[2]} by {text[3]} px")
        for name in ("Next Notice", "Close Notice"):
            x, y, across, down = app.settled(app.find("button", name))
            check(left <= x and x + across <= left + width and y + down <= top + height / 2, f"{name} is over the canvas")


def test_notice_over_a_low_canvas(display):
    """Beside a graph in the smallest window a long notice leaves most of the canvas to what moves. One ball strikes two."""
    balls = [{"type": "disc", "name": f"Ball {i}", "radius": 0.5, "position": [x, 0], "restitution": 1, "solid": True}
             for i, x in enumerate((-2, 0, 1))]
    balls[0]["velocity"] = [2, 0]
    with App(display, scene(*balls, duration=1, graphs=[{"block": "Ball 0", "quantity": "x"}])) as app:
        make_small(app)
        wait(lambda: app.canvas_box()[3] < 300, "a low canvas")
        app.click("Play")
        text = app.find("button", re.compile("one blow after the other differ"))
        button = app.find("button", "Choose the Law of Impact")
        top, height = app.canvas_box()[1::2]
        for node in (text, button):
            check(sum(app.settled(node)[1::2]) < top + height / 2, f"{node.name} leaves what is below it to the canvas")


def make_small(app):
    """800 by 500 pixels, the least there may be."""
    widest = max(app.windows(), key=lambda window: window[1][2])  # others are tips
    app.xdotool("windowsize", widest[0], 800, 500)
    wait(lambda: width_of_window(app) == 800, "the window to be small")


def shows(app, x, y):
    """Whether a place of the world is on the canvas."""
    left, top, width, height = app.canvas_box()
    across, down = app.at(x, y)
    return left < across < left + width and top < down < top + height


def test_small_window_shows_all_of_the_scene(display):
    """Blocks are symbols there, with their names in tooltips; graphs give way with the canvas, which shows what it showed
    before. Blocks can be found and placed as ever."""
    ends = (-4.5, -2), (4.5, 2.5)
    with App(display, scene(mass("Low", *ends[0]), mass("High", *ends[1]), graphs=[{"block": "Low", "quantity": "y"}])) as app:
        app.find(None, re.compile("^Graph of "))
        names = app.find("label", "Torsional Spring")
        before = app.canvas_box()
        make_small(app)
        wait(lambda: app.look("label", "Torsional Spring") is None, f"{names.name} to give way")
        _, _, width, height = wait(lambda: app.canvas_box()[2] < before[2] and app.canvas_box(), "a smaller canvas")
        check(width >= 360 and height >= 200, f"the canvas is {width} by {height} px")
        wait(lambda: all(shows(app, *end) for end in ends), "both bodies to be in view")
        check(app.settled(app.find(None, re.compile("^Graph of ")))[3] >= 120, "the graph has room to be read")
        app.retype(app.find(None, "Find a Block"), "torsional damper")
        app.press("Return")
        app.find_starting("list item", "Torsional Damper 0")
        window = max(app.windows(), key=lambda window: window[1][2])
        app.xdotool("windowsize", window[0], 1200, 750)
        app.find("label", "Torsional Spring")


def test_where_somebody_looks_stays_when_the_window_is_sized(display):
    with App(display, scene(mass("Low", -4.5, -2), mass("High", 4.5, 2.5))) as app:
        app.press("ctrl+plus")
        zoomed = wait(lambda: app.canvas_box()[2] / app.view()[0], "a zoomed view")
        make_small(app)
        wait(lambda: app.canvas_box()[2] < 500, "a smaller canvas")
        check(abs(app.canvas_box()[2] / app.view()[0] - zoomed) < 0.5, "pixels per m stay")


def test_scene_is_below_a_high_notice(display):
    """One of several lines, as in a small window, has no room in what is left free for one. When it has gone the room is the
    scene's, as soon as the window has another size."""
    with App(display, scene(support("Floor", 0, -2), mass("Box", 0, -1.7), mass("High", 0, 4), width=4)) as app:
        make_small(app)
        notice = app.find("button", re.compile("^Box starts "))
        bar = app.find("button", "Close Notice")

        def is_below():
            return app.at(0, 4.4)[1] > max(sum(app.box(node)[1::2]) for node in (notice, bar))

        wait(is_below, "the highest block to be below the notice")
        free = app.at(0, 4.4)[1] - app.canvas_box()[1]
        app.click("Close Notice")
        window = max(app.windows(), key=lambda window: window[1][2])
        app.xdotool("windowsize", window[0], 800, 520)
        wait(lambda: app.at(0, 4.4)[1] - app.canvas_box()[1] < free - 5, "the room of the notice to be the scene's")


def test_first_steps_can_be_read_in_a_small_window(display):
    with App(display) as app:
        app.find(None, "First Steps")
        make_small(app)
        left, top, width, height = app.canvas_box()
        for text in ("Build Something That Moves", "Drag the ends of springs, dampers and the like onto blocks to connect them."):
            x, _, across, _ = app.settled(app.find("label", text))
            check(left <= x and x + across <= left + width, f"“{text}” is whole on the canvas")
        example = app.find("button", "Double pendulum")
        wait(lambda: app.settled(example)[1] + example.box()[3] <= top + height, "the last example to be whole on the canvas")
        check(app.settled(app.find("label", "Build Something That Moves"))[1] >= top, "and the title as well")
        app.click("All Examples…")
        app.find(None, "Examples")


def test_mark_at_the_edge_is_not_beneath_a_notice(display):
    with App(display, scene(support("Floor", 0, 0), mass("Box", 0, 0.3), mass("High", 0, 50), width=10)) as app:
        app.show_width()
        notice = app.settled(app.find("button", re.compile("^Box starts ")))
        left, top, width, height = app.canvas_box()
        middle, below = left + width / 2, notice[1] + notice[3]
        strip = (middle - 12, below, middle + 12, below + 40)
        wait(lambda: colours.fill_count(app.picture(), strip, BODY_EDGE) > 40, "a mark below the notice")
        app.click("Close Notice")
        strip = (middle - 12, top, middle + 12, top + 24)
        wait(lambda: colours.fill_count(app.picture(), strip, BODY_EDGE) > 40, "a mark at the upper edge, without a notice")


def test_mark_at_the_edge_is_not_upon_a_field(display):
    """Bodies out of sight to the upper left: their marks are beside and below gravity's arrow and name."""
    with App(display, scene(GRAVITY, support("Floor", 0, 0), mass("High", -4.9, 50), mass("Left", -50, 3.5), width=10)) as app:
        app.show_width()
        left, top, _, _ = app.canvas_box()
        wait(lambda: colours.fill_count(app.picture(), (left, top, left + 120, top + 120), BODY_EDGE) > 80, "two marks")
        check_equal(colours.fill_count(app.picture(), (left, top, left + 50, top + 60), BODY_EDGE), 0, "pixels of them upon gravity")


def test_mark_at_the_edge_is_in_the_view_however_wide_the_fields_are(display):
    """A body above the view: beside fields that end six pixels from the edge is no room for its mark, so that it is below them."""
    fields = [{**GRAVITY, "name": f"g{i}"} for i in range(30)]
    with App(display, scene(*fields, mass("High", -4.9, 50), width=10)) as app:
        app.show_width()
        left, top, width, height = app.canvas_box()
        wait(lambda: colours.fill_count(app.picture(), (left, top, left + width, top + height), BODY_EDGE) > 40, "the mark")


def test_names_of_the_pages_are_whole_in_a_small_window(display):
    with App(display, scene(mass("Ball", 0, 0))) as app:
        widest = max(app.windows(), key=lambda window: window[1][2])
        whole = {name: app.find("label", name, inside=app.find("tab", name)).box()[2] for name in ("Model", "Graphs", "Accuracy")}
        app.xdotool("windowsize", widest[0], 800, 500)
        wait(lambda: width_of_window(app) == 800, "the window to be small")
        for name, width in whole.items():
            check_equal(app.find("label", name, inside=app.find("tab", name)).box()[2], width, f"width of {name} (px)")


def test_crowded_curve_in_a_small_window_while_it_plays(display):
    """Forty swings in a graph of some hundred pixels: cairo's fast smoothing wrote beyond its memory, and the program ended."""
    scenes = pathlib.Path(__file__).resolve().parents[3] / "host" / "scenes"
    with App(display, json.loads((scenes / "beats.tinker.json").read_text())) as app:
        app.activate("play")
        widest = max(app.windows(), key=lambda window: window[1][2])
        app.xdotool("windowsize", widest[0], 800, 500)
        wait(lambda: width_of_window(app) == 800, "the window to be small")
        wait(lambda: app.time() > 1, "it to play on")


TAKES_FOCUS = ("button", "toggle button", "check box", "entry", "text", "slider", "combo box")
PLAY_BAR = ["Reset to the Start", "One Sample Back", "Play", "One Sample Forward", "Time line", "Time"]


def test_what_takes_the_focus_is_named(display):
    """By what it does; a name such as GtkMenuButton is that of a class. What a list to choose from is made of is part of it."""
    with App(display, scene(support("Floor", 0, 0), mass("Box", 0, 2))) as app:
        nameless = [node for node in app.tree.refresh(True)
                    if node.role in TAKES_FOCUS and node.is_shown() and not any(o.role == "combo box" for o in node.ancestors())
                    and (not node.name or re.match("(Gtk|Adw|Tinker)[A-Z]", node.name))]
        check_equal(nameless, [], "what has no name")


def test_tab_goes_through_the_play_bar_from_left_to_right(display):
    with App(display, scene(support("Floor", 0, 0), mass("Box", 0, 2))) as app:
        app.click(PLAY_BAR[0])
        passed = []
        for _ in PLAY_BAR:
            passed.append(wait(lambda: next((n.name for n in app.tree.refresh() if n.has("focused") and n.name not in passed), None),
                               "the next one to have the focus"))
            app.press("Tab")
        check_equal(passed, PLAY_BAR, "the order")


def test_long_name_makes_nothing_wider(display):
    with App(display, scene(support("Floor", 0, 0), mass("Box", 0, 0.3), GRAVITY)) as app:
        before = width_of_window(app)
        app.click_world(0.2, 0.5)
        app.enter("Appearance", "Name", LONG)
        app.find("button", re.compile("^Super.* starts .* below the top of Floor"))
        app.find_starting("list item", LONG)
        check_equal(width_of_window(app), before, "width of the window (px)")
        app.click("Graphs", role="tab")
        app.find("button", "Add Graph")
        check_equal(width_of_window(app), before, "width of the window with the page of graphs (px)")


def test_play_bar_is_a_strip_below_everything(display):
    with App(display, scene(mass("Ball", 0, 0))) as app:
        line, canvas = app.settled(app.find("slider", "Time line")), app.canvas_box()
        check(line[1] >= canvas[1] + canvas[3], "the time line lies over the canvas")
        check(line[2] >= width_of_window(app) / 2, f"the time line is {line[2]:g} px long")
        app.click("Graphs", role="tab")
        app.find("button", "Add Graph")
        check_equal(app.settled(app.find("slider", "Time line")), line, "place of the time line on another page")


def test_typed_time_is_gone_to(display):
    with App(display, scene(mass("Ball", 0, 3), GRAVITY, duration=2)) as app:
        app.click_world(0.2, 3.2)
        entry = app.find("text", "Time")
        app.retype(entry, "0.5")
        app.press("Return")
        wait(lambda: app.time() == 0.5 and not app.is_playing(), "0.5 s, which is run first")
        app.retype(entry, "250 ms")
        app.press("Return")
        wait(lambda: app.time() == 0.25, "0.25 s")
        app.retype(entry, "soon")
        app.press("Return")
        wait(lambda: app.look("text", "Time", description="number"), "the entry to say what is wrong")
        app.press("Escape")
        wait(lambda: app.time() == 0.25, "the time that is shown")
        app.retype(entry, "7")
        app.press("Return")
        wait(lambda: app.time() == 2 and not app.is_playing(), "the end of the run")


def test_side_panels_fold_away_and_stay_so(display):
    with App(display, scene(mass("Ball", 0, 0))) as app:
        left, _, before, _ = app.canvas_box()
        right, all_of_it = left + before, app.look("window").box()[2]
        app.press("F9")
        wait(lambda: app.canvas_box()[0] < left, "the palette to fold away")
        check_equal(app.canvas_box()[0] + app.canvas_box()[2], right, "right edge of the canvas")
        app.press("shift+F9")
        wait(lambda: app.canvas_box()[2] == all_of_it, "the canvas to be as wide as the window")
        home = app.home
    with App(display, scene(mass("Ball", 0, 0)), home=home) as app:
        check_equal(app.canvas_box()[2], all_of_it, "width of the canvas in the next window")
        app.click("Show Blocks", role=None)
        app.click("Show Properties and Outline", role=None)
        wait(lambda: app.canvas_box()[2] == before, "both to be there again")


def test_insert_places_by_keys_alone(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        app.click_world(2, 2)
        app.press("Insert", "Down", "Return")  # the first is a bar, the second a box
        app.find_starting("list item", "Box")
        check_equal(sorted(block["type"] for block in app.blocks().values()), ["box", "mass"], "blocks")
        app.press("Delete")  # the canvas has the focus again, and the new block is selected
        check_equal(list(app.blocks()), ["A"], "blocks")
        app.press("Insert", "Return")  # the list is where it was left
        app.find_starting("list item", "Box")
        app.press("Delete", "Insert")
        app.type("spring")  # of which more than the spring tell, a bumper first
        app.press("Return")
        wait(lambda: sorted(block["type"] for block in app.blocks().values()) == ["mass", "spring"], "a spring")


def test_menu_of_what_is_selected_by_key(display):
    with App(display, scene(mass("A", -2, 0), mass("B", 2, 0))) as app:
        app.click_world(-1.8, 0.2)
        for keys in ("Menu", "shift+F10"):
            app.press(keys)
            app.find_item("Add Graph")
            app.press("Escape")
            wait(lambda: app.look(None, "Add Graph") is None, "the menu to close")
        app.press("Menu")
        app.choose("Delete")
        wait(lambda: list(app.blocks()) == ["B"], "what was selected to go")


def test_canvas_says_what_is_selected(display):
    with App(display, scene(mass("A", -2, 0), mass("B", 2, 0))) as app:
        wait(lambda: "nothing is selected" in app.canvas().description, "nothing to be selected")
        app.click_world(-2, 0.2)
        wait(lambda: app.canvas().description.endswith("; A, Mass, at (-2.00000 m, 0.00000 m)"), "A to be told of")
        app.click_world(2, 0.2, keys=["shift"])
        wait(lambda: "2 blocks are selected" in app.canvas().description, "both to be told of")


def test_outline_has_the_menu_of_the_canvas(display):
    with App(display, scene(mass("A", -2, 0), mass("B", 2, 0))) as app:
        app.click(app.find_starting("list item", "B, Mass"), button=3)
        app.choose("Delete")
        wait(lambda: app.look("list item", re.compile("^B, ")) is None, "B to go")
        check_equal(list(app.blocks()), ["A"], "blocks")


def test_scene_is_introduced_when_it_is_opened(display):
    told = "A ball falls for two seconds.\nIt is the first thing that anybody computes."
    with App(display, scene(mass("Ball", 0, 3), GRAVITY, title="The Fall", description=told)) as app:
        app.find("label", "The Fall")
        check_equal(app.find("label", told).box()[2] > 200, True, "the description has room to be read")
        app.find("label", re.compile("Left out"))
        app.click_world(0.2, 3.2)
        app.wait_read("Appearance", "Name", "Ball")
        app.click("Scene", role="tab")
        app.find("label", told)
    with App(display, scene(mass("Ball", 0, 3))) as app:
        app.find("label", "Canvas")  # nothing is told: the properties of the scene are there


if __name__ == "__main__":
    main()
