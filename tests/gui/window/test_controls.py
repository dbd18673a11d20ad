#!/usr/bin/python3
"""Controls and meters on the canvas: added by menus, turned by mouse and keys, moved, saved."""
import math
import re

from harness import App, check, check_close, check_equal, main, mass, scene, spring, support, wait

OSCILLATOR = (support("Roof", 0, 4, orientation="180 deg"), mass("Bob", 0, 1), spring("Coil", "Roof", "Bob", stiffness=25, rest_length=2))


def oscillator(**more):
    return scene(*OSCILLATOR, duration=4, **more)


STIFFNESS = {"block": "Coil", "property": "stiffness", "from": 0, "to": 100, "kind": "slider", "place": [-4.5, 2]}
HEIGHT = {"block": "Bob", "quantity": "y", "kind": "number", "place": [2, 2]}


def height_shown(app):
    meter = app.find(None, "Meter of Bob: Y Position").refreshed()
    read = re.match(r"(\S+) m$", meter.description)
    return float(read.group(1)) if read else None


def test_added_by_the_menu(display):
    with App(display, oscillator()) as app:
        app.show_width()
        app.click_world(0.13, 1.13, button=3)
        app.choose("Add Control", "Mass")
        app.find("slider", "Bob: Mass")
        app.click_world(0.13, 1.13, button=3)
        app.choose("Add Meter", "Speed")
        app.find(None, "Meter of Bob: Speed")
        saved = app.saved()
        check_equal([(each["block"], each["property"], each["kind"]) for each in saved["controls"]],
                    [("Bob", "mass", "slider")], "controls in the file")
        check_equal(saved["controls"][0]["to"], 2, "twice the mass of 1 kg")
        check_equal([(each["block"], each["quantity"]) for each in saved["meters"]], [("Bob", "speed")], "meters in the file")
        app.press("ctrl+z", "ctrl+z")
        app.gone("slider", "Bob: Mass")
        check("controls" not in app.saved(), "no control is left")


def test_neither_covers_the_other_whatever_it_becomes(display):
    """A meter and a control that are added one after the other are a dial and a knob afterwards, which are higher."""
    with App(display, oscillator()) as app:
        app.show_width()
        app.click_world(0.13, 1.13, button=3)
        app.choose("Add Meter", "Speed")
        app.click_world(0.13, 1.13, button=3)
        app.choose("Add Control", "Mass")
        for name, kind in (("Meter of Bob: Speed", "Dial"), ("Control of Bob: Mass", "Knob")):
            x, y, width, _ = app.settled(app.find(None, name))
            app._click_at(x + width / 2, y + 8, button=3)
            app.choose(kind)
            wait(lambda: kind.lower() in str(app.saved()), f"a {kind} in the file")
        meter, control = (app.settled(app.find(None, name)) for name in ("Meter of Bob: Speed", "Control of Bob: Mass"))
        check(any(a[k] + a[k + 2] <= b[k] for k in (0, 1) for a, b in ((meter, control), (control, meter))),
              f"{meter} is beside {control}")


def test_none_covers_another_or_a_body_in_a_small_window(display):
    """Five that stand apart on a large canvas would cover each other on that of the least window there may be."""
    controls = [{"block": "Bob", "property": "mass", "from": 0.5, "to": 2, "kind": "knob", "place": [0.2, 3.6]},
                {**STIFFNESS, "place": [2.2, 1.4]}]
    meters = [{"block": "Bob", "quantity": "speed", "kind": "dial", "place": [-4.9, 1.8]},
              {**HEIGHT, "place": [-4.9, 0.2]}, {"block": "Coil", "quantity": "tension", "kind": "number", "place": [0.6, -0.4]}]
    with App(display, oscillator(controls=controls, meters=meters)) as app:
        widest = max(app.windows(), key=lambda window: window[1][2])
        app.xdotool("windowsize", widest[0], 800, 500)
        wait(lambda: app.canvas_box()[2] < 450, "the canvas to be small")
        app.find(None, "Control of Bob: Mass")
        names = [re.compile(f"^{kind} of ") for kind in ("Control", "Meter")]
        nodes = [node for node in app.tree.refresh() if node.is_shown() and any(name.match(node.name) for name in names)]
        share = app.canvas_box()[2] / 560  # they are drawn that much smaller, of which the tree knows the corner alone
        boxes = [(x, y, share * width, share * height) for x, y, width, height in map(app.settled, nodes)]
        left, top, right, bottom = app.area(-0.4, 0.6, 0.4, 1.4)  # Bob
        boxes.append((left, top, right - left, bottom - top))
        check_equal(len(boxes), 6, "instruments, and Bob")
        for i, a in enumerate(boxes):
            for b in boxes[:i]:
                check(any(p[k] + p[k + 2] <= q[k] + 1 for k in (0, 1) for p, q in ((a, b), (b, a))), f"{a} covers {b}")


def test_meter_makes_way_for_a_swing_in_a_small_window(display):
    """Not before the run is known, and then once: a bob on a spring along x comes to the meter that stood beside it."""
    spring = [{"type": "support", "name": "Wall", "position": [-4, 1]}, {"type": "mass", "name": "Bob", "position": [-1.5, 1]},
              {"type": "spring", "name": "Coil", "ends": ["Wall", "Bob"], "stiffness": 25, "rest_length": 4},
              {"type": "support", "name": "Post", "position": [4, 1], "width": 1}]
    meter = {"block": "Bob", "quantity": "x", "place": [0.2, 1.5]}
    with App(display, scene(*spring, duration=4, canvas={"width": 10}, meters=[meter])) as app:
        widest = max(app.windows(), key=lambda window: window[1][2])
        app.xdotool("windowsize", widest[0], 800, 500)
        wait(lambda: app.canvas_box()[2] < 450, "the canvas to be small")
        node = app.find(None, re.compile("^Meter of "))
        share = app.canvas_box()[2] / 560

        def meets_the_way():
            x, y, width, height = app.settled(node)
            left, top, right, bottom = app.area(-1.9, 0.6, 1.9, 1.4)  # what the bob sweeps: 0 ± 1.5 m, and its size
            return x < right and x + share * width > left and y < bottom and y + share * height > top

        check(meets_the_way(), "where it was put it is not in the way")
        app.press("space")
        wait(lambda: not meets_the_way(), "it to make way")
        place = app.settled(node)
        wait(lambda: not app.is_playing(), "the end")
        check_equal(app.settled(node), place, "where it has gone to")


def test_meter_that_was_placed_before_any_run_makes_way(display):
    """In a large window as well: where there was room for it a body comes that is thrown up. Where a hand has put it, it stays."""
    with App(display, scene(mass("Bob", 3.9, -3, velocity=[0, 1.7]), duration=4, canvas={"width": 10})) as app:
        app.show_width()
        app.click_world(4.03, -2.87, button=3)
        app.choose("Add Meter", "Speed")
        node = app.find(None, re.compile("^Meter of "))

        def meets_the_way():
            x, y, width, height = app.settled(node)
            left, top, right, bottom = app.area(3.5, -3.4, 4.3, 4.2)  # what the body sweeps: -3 m to 3.8 m, and its size
            return x < right and x + width > left and y < bottom and y + height > top

        check(meets_the_way(), "before the run its place is in the way")
        check(app.saved()["meters"][0]["makes_way"], "the file knows that nobody chose the place")
        app.press("space")
        wait(lambda: not meets_the_way(), "it to make way")
        wait(lambda: not app.is_playing(), "the end")
        check(not meets_the_way(), "it is out of the way at the end")
        x, y, width, _ = app.settled(node)
        app.drag_pixels((x + width / 2, y + 8), app.at(3.9, 1))
        wait(meets_the_way, "it to stay where it was put")
        check("makes_way" not in app.saved()["meters"][0], "the file knows that a hand has put it there")


def test_meter_makes_way_in_a_scene_that_is_opened(display):
    """Placed before any run and saved, one is beside the way of a run; one whose place was chosen stays in it."""
    meters = [{"block": "Bob", "quantity": quantity, "place": [3.2, y], "makes_way": makes_way}
              for quantity, y, makes_way in (("y", 2.5, True), ("vy", -0.5, False))]
    with App(display, scene(mass("Bob", 3.9, -3, velocity=[0, 1.7]), duration=4, canvas={"width": 10},
                            meters=meters)) as app:
        app.show_width()

        def meets_the_way(quantity):
            x, y, width, height = app.settled(app.find(None, re.compile(f"^Meter of .*{quantity}")))
            left, top, right, bottom = app.area(3.5, -3.4, 4.3, 4.2)  # what the body sweeps: -3 m to 3.8 m, and its size
            return x < right and x + width > left and y < bottom and y + height > top

        app.press("space")
        wait(lambda: not app.is_playing() and app.time() == 4, "the end")
        wait(lambda: not meets_the_way("Position"), "the one that makes way to do so")
        check(meets_the_way("Velocity"), "the other stays")


def test_meter_makes_way_for_a_notice(display):
    """And goes back to its place when that is gone."""
    meter = {"block": "A", "quantity": "x", "place": [-1, 99]}  # beyond the top: shown at it
    with App(display, scene(mass("A", -1, 0, velocity=[1, 0]), mass("B", 1, 0), duration=4, meters=[meter])) as app:
        notice, node = app.find("button", re.compile("pass through each other")), app.find(None, re.compile("^Meter of "))
        _, top, _, height = app.settled(notice)
        wait(lambda: app.settled(node)[1] > top + height, "it to stand below the notice")
        app.click("Close Notice")
        wait(lambda: app.settled(node)[1] < top + height, "it to go back")


def test_added_by_the_property(display):
    with App(display, oscillator()) as app:
        app.show_width()
        app.click_world(0.13, 1.13)
        app.bring_into_view(app.field("Properties", "Mass"))
        app.click(app.field("Properties", "Mass"), button=3)
        app.choose("Add Control")
        app.find("slider", "Bob: Mass")
        check_close(app.saved()["controls"][0]["step"], 0.02, 1e-12, "its step")


def test_meter_by_keys_alone(display):
    """Added by the menu of what is selected, made a dial by its own, and moved."""
    with App(display, scene(mass("Ball", -2, 0, velocity=[0, 3]), duration=1)) as app:
        def focused():
            return [node.name for node in app.tree.refresh() if node.has("focused")]

        def go_to(name, key):
            for _ in range(60):
                if any(name in other for other in focused()):
                    return
                app.press(key)
                app.tree.refresh()
            check(False, f"{key} does not come to {name}")

        def choose(*names):
            for name in names:
                go_to(name, "Down")
                app.press("Return")

        app.press("Tab")  # selects the block
        app.press("shift+F10")
        choose("Add Meter", "Speed")
        wait(lambda: app.saved().get("meters"), "the meter")
        go_to("Meter of Ball: Speed", "Tab")
        app.press("Menu")
        choose("Dial")
        wait(lambda: app.saved()["meters"][0]["kind"] == "dial", "it to be a dial")
        place = app.saved()["meters"][0]["place"]
        app.press("shift+Left")
        wait(lambda: app.saved()["meters"][0]["place"][0] < place[0], "it to be moved")


def test_menu_of_a_title_is_not_beneath_its_tooltip(display):
    with App(display, oscillator()) as app:
        app.show_width()
        app.click_world(0.13, 1.13)
        app.bring_into_view(app.field("Properties", "Mass"))
        title = next(node for node in app.tree.refresh() if node.role == "label" and node.name == "Mass" and
                     any(other.name == "TinkerPropertyField" for other in node.ancestors()))
        windows = len(app.windows())
        app.xdotool("mousemove", *app.middle(title))
        wait(lambda: len(app.windows()) > windows, "its tooltip")
        app._click_at(*app.middle(title), button=3)
        app.choose("Add Control")
        app.find("slider", "Bob: Mass")


def test_curve_follows_the_hand(display):
    """At 4 s the mass is at 2 - cos(4 omega) m, omega the root of the stiffness."""
    with App(display, oscillator(controls=[STIFFNESS], meters=[HEIGHT])) as app:
        app.click("Play")
        wait(lambda: app.time() == 4 and not app.is_playing(), "the end of the run")
        wait(lambda: height_shown(app) == round(2 - math.cos(20), 3), "the height with 25 N/m")
        slider = app.find("slider", "Coil: K")
        x, y, width, height = app.settled(slider)
        app.drag_pixels((x + 8 + 0.25 * (width - 16), y + height / 2), (x + 0.6 * width, y + height / 2))
        wait(lambda: slider.value() > 50, "the slider to be drawn")
        omega = math.sqrt(slider.value())
        wait(lambda: height_shown(app) is not None and abs(height_shown(app) - (2 - math.cos(4 * omega))) < 2e-3,
             "the height with another stiffness")
        check_equal(app.time(), 4, "the time that is shown")
        check_close(app.saved()["blocks"][2]["stiffness"], slider.value(), 1e-9, "stiffness in the file")
        app.click("Undo")
        wait(lambda: slider.value() == 25, "one step back to what it was")


def test_keys(display):
    with App(display, oscillator(controls=[{**STIFFNESS, "step": 5}])) as app:
        slider = app.find("slider", "Coil: K")
        app.click(slider)
        app.press("Home")
        wait(lambda: slider.value() == 0, "the least")
        app.press("Right", "Right")
        wait(lambda: slider.value() == 10, "two steps")
        app.press("shift+Right", "shift+Down")
        left, top = app.saved()["controls"][0]["place"]
        check(left > -4.5 and top < 2, f"it was moved to ({left}, {top})")
        app.press("Delete")
        app.gone("slider", "Coil: K")


def test_typed_value(display):
    """A number that is typed is taken as it is, and one beyond the range widens that."""
    with App(display, oscillator(controls=[STIFFNESS])) as app:
        value = app.find("text", "Value of Coil: K")
        app.retype(value, "2*32.5")
        app.press("Return")
        wait(lambda: app.blocks()["Coil"]["stiffness"] == 65, "the number that was typed")
        wait(lambda: app.find("slider", "Coil: K").value() == 65, "the slider at it")
        app.retype(app.find("text", "Value of Coil: K"), "0.25 kN/m")
        app.press("Return")
        wait(lambda: app.blocks()["Coil"]["stiffness"] == 250, "a number beyond the range")
        check_equal(app.saved()["controls"][0]["to"], 250, "the end of the range")


def test_what_goes_along_is_told(display):
    """The static coefficient is no less than the dynamic one: it goes along and comes back, and both are said."""
    control = {"block": "Floor", "property": "dynamic_friction", "from": 0, "to": 1, "step": 0.1, "kind": "slider",
               "place": [-4.5, 2]}
    with App(display, scene(support("Floor", 0, -2, static_friction=0.3, dynamic_friction=0.2), mass("Bob", 0, 1),
                            controls=[control])) as app:
        app.click(app.find("slider", re.compile("^Floor: ")))
        app.press("Home", *["Right"] * 5)
        app.find("label", re.compile("goes along: 0.5 .was 0.3.$"))
        check_equal(app.blocks()["Floor"]["static_friction"], 0.5, "static friction in the file")
        app.press(*["Left"] * 3)
        wait(lambda: app.look("label", re.compile("goes along")) is None, "the words to go")
        check_equal(app.blocks()["Floor"]["static_friction"], 0.3, "static friction, back")


def test_what_is_wrong_with_a_typed_value_stays_while_it_plays(display):
    """As long as the number stands there, and no longer: Escape takes both away."""
    with App(display, {**oscillator(controls=[STIFFNESS]), "run": {"duration": 600, "interval": 0.01}}) as app:
        app.click("Play")
        for text, why in (("abc", "a number is expected"), ("-3", "must be")):
            app.retype(app.find("text", "Value of Coil: K"), text)
            app.press("Return")
            app.find_text(why)
            before = app.time()
            wait(lambda: app.time() > before + 1, "it to play on")
            app.find_text(why)
            app.press("Escape")
            wait(lambda: app.look("label", app.pattern(why)) is None, "the message to go")
        check(app.is_playing(), "it plays on")


def test_moved_by_its_title(display):
    with App(display, oscillator(meters=[HEIGHT])) as app:
        app.show_width()
        title = app.find("label", "Bob: Y Position")
        x, y = app.middle(title)
        app.drag_pixels((x, y), (x - 60, y + 40))
        left, top = app.saved()["meters"][0]["place"]
        scale = app.scale()
        check_close(left, 2 - 60 / scale, 1.5 / scale, "its left edge (m)")
        check_close(top, 2 - 40 / scale, 1.5 / scale, "its upper edge (m)")


def test_other_kinds_and_range(display):
    with App(display, oscillator(controls=[STIFFNESS], meters=[HEIGHT])) as app:
        app.click(app.find(None, "Control of Coil: K"), button=3)
        app.choose("Knob")
        wait(lambda: app.saved()["controls"][0]["kind"] == "knob", "a knob in the file")
        knob = app.find("slider", "Coil: K")
        x, y = app.middle(knob)
        app.drag_pixels((x, y), (x, y - 40))
        wait(lambda: abs(app.blocks()["Coil"]["stiffness"] - 50) < 1.5, "a quarter of the range more")
        app.click(app.find("label", "Coil: K"), button=3)
        app.choose("Set Range…")
        to = app.find("text", "To")
        app.retype(to, "10 kN/m")
        app.press("Return")
        wait(lambda: app.saved()["controls"][0]["to"] == 10000, "the range in the file")
        app.click(app.find(None, "Meter of Bob: Y Position"), button=3)
        app.choose("Dial")
        wait(lambda: app.saved()["meters"][0]["kind"] == "dial", "a dial in the file")


def test_switch(display):
    with App(display, scene(support("Floor", 0, -2), mass("Bob", 0, 1), {"type": "gravity", "name": "Gravity"},
                            controls=[{"block": "Floor", "property": "solid", "kind": "switch", "place": [-4.5, 2]}])) as app:
        switch = app.find("check box", "Floor: Solid")
        app.click(switch)
        wait(lambda: app.blocks()["Floor"].get("solid") is False, "a floor that nothing meets")


if __name__ == "__main__":
    main()
