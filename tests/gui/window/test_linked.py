#!/usr/bin/python3
"""What is pointed at in one view lights up in all others: blocks, arrows, terms, curves, diagram and books."""
import re
import time

from harness import App, check, main, mass, scene, spring, support, wait

GRAVITY = {"type": "gravity", "name": "Gravity", "acceleration": 10}
NORMAL = re.compile(r"^Floor: plus N")
FRICTION = re.compile(r"^Floor: minus .*mu")
WEIGHT = re.compile(r"^Gravity: minus m times g|^Gravity: minus m \w+ times g")
NOWHERE = 3, 2.5  # m: on the canvas, away from all


def sliding(**more):
    """Friction, 8 N to the left, starts at (0, -0.2), where the normal force, 20 N upwards, ends; the weight starts at (0, 0.2), and
    so that they do not lie on each other the normal force stands a little, 0.1 m, to the right."""
    return scene(GRAVITY, support("Floor", 0, -0.5, width=10, height=0.6, static_friction=0.5, dynamic_friction=0.4),
                 mass("Bob", 0, 0.2, mass=2, velocity=[3, 0]), **more)


class Watched:
    """Pictures of parts of the window while nothing is pointed at, and whether they are others now."""

    def __init__(self, app, **parts):
        self.app = app
        app.xdotool("mousemove", *app.at(*NOWHERE))
        app.still_picture(-1, -1, 1, 1)
        self.parts = parts
        picture = app.picture()
        self.dark = {name: picture.cut(part) for name, part in parts.items()}

    def lit(self):
        picture = self.app.picture()
        return {name for name, part in self.parts.items() if picture.cut(part) != self.dark[name]}

    def wait_lit(self, *names):
        wait(lambda: self.lit() == set(names), f"{', '.join(names) or 'nothing'} and nothing else to light up")


def part_of(app, name):
    x, y, width, height = app.box(app.find("image", name))
    return x, y, x + width, y + height


def watch_terms(app, **more):
    app.show_width()
    app.click("Equations", role="tab")
    return Watched(app, normal=part_of(app, NORMAL), friction=part_of(app, FRICTION), weight=part_of(app, WEIGHT), **more)


def test_arrow_on_the_canvas_lights_its_term(display):
    """Normal force and friction are of one block: each lights up its own term."""
    with App(display, sliding()) as app:
        app.activate("show-forces")
        watched = watch_terms(app)
        for place, name in (((-0.2, -0.2), "friction"), ((0.1, -0.9), "normal"), ((0, 0), "weight")):
            app.xdotool("mousemove", *app.at(*place))
            watched.wait_lit(name)
        app.xdotool("mousemove", *app.at(*NOWHERE))
        watched.wait_lit()


def test_arrow_on_the_canvas_lights_its_block(display):
    """The spring runs from (0, 1) to (3, 1), and pulls at what is left of it."""
    content = scene(mass("Bob", 0, 1), mass("Tom", 3, 1), spring("Spring", "Bob", "Tom", stiffness=5, rest_length=1))
    with App(display, content) as app:
        app.activate("show-forces")
        app.show_width()
        app.click("Equations", role="tab")
        app.find("image", re.compile("^Spring: "))
        watched = Watched(app, spring=app.area(1.3, 0.6, 1.7, 1.4))
        app.xdotool("mousemove", *app.at(0.15, 1))
        watched.wait_lit("spring")


def test_term_lights_its_own_arrow(display):
    """The other one of the floor, which acts at the same place, is faded, and stands out when it is meant."""
    with App(display, sliding()) as app:
        app.activate("show-forces")
        app.show_width()
        app.click("Equations", role="tab")
        terms = {name: app.middle(app.find("image", name)) for name in (FRICTION, NORMAL)}
        watched = Watched(app, normal=app.area(0.06, -0.95, 0.14, -0.86))
        app.xdotool("mousemove", *terms[FRICTION])
        watched.wait_lit("normal")
        app.xdotool("mousemove", *terms[NORMAL])
        watched.wait_lit()


def seen(app, node):
    """What of a picture is above the outline."""
    x, y, width, height = app.box(node)
    return x, max(y, 130), width, min(y + height, app.box(app.find("label", "Outline"))[1]) - max(y, 130)


def scan(app, watched, box, wanted):
    """Moves the pointer down the middle of a box until this, and nothing else of what is watched, is lit."""
    x, y, width, height = box
    for place in range(int(y) + 4, int(y + height), 8):
        app.xdotool("mousemove", x + width // 2, place)
        for _ in range(4):
            time.sleep(0.05)
            if watched.lit() == wanted:
                return
    check(False, f"somewhere {wanted} is lit alone")


def test_rows_of_the_diagram_light_their_terms(display):
    with App(display, sliding()) as app:
        app.click_block("Bob")
        app.click("Equations", role="tab")
        diagram = app.find("image", "Free-body diagram")
        top = app.settled(diagram)[1]
        app.xdotool("mousemove", *app.middle(app.find("image", NORMAL)))
        app.xdotool("click", "5")  # so that its rows are seen, and the terms, too
        wait(lambda: app.box(diagram)[1] < top - 30, "the page to scroll")
        app.settled(diagram)
        watched = watch_terms(app)
        box = app.box(diagram)
        for name in ("weight", "normal", "friction"):
            scan(app, watched, (box[0], box[1] + box[3] // 2, box[2], box[3] // 2), {name})


def click_at_edge(app, node):
    x, y, width, _ = app.settled(node)
    app._click_at(x + width - 8, y + 8)


def test_keys_go_through_the_diagram(display):
    """What they have reached is told, and lights up."""
    with App(display, sliding()) as app:
        app.click_block("Bob")
        app.show_width()
        app.click("Equations", role="tab")
        diagram = app.find("image", "Free-body diagram")
        click_at_edge(app, diagram)  # which scrolls it into view
        for _ in range(2):
            app.click("Values", role="check box")
        watched = watch_terms(app)
        click_at_edge(app, diagram)
        app.xdotool("mousemove", *app.at(*NOWHERE))
        for told, name in ((r"^Gravity +20 N$", "weight"), (r"^Floor \(Normal force\) +20 N$", "normal"),
                           (r"^Floor \(Friction\) +8 N$", "friction")):
            app.press("Up", "Up", "Up", "Up")
            for _ in range(4):
                if re.search(told, diagram.refreshed().description or ""):
                    break
                app.press("Down")
            check(re.search(told, diagram.refreshed().description), f"{told} is told, not {diagram.description}")
            watched.wait_lit(name)


def test_books_light_the_arrows_of_a_block(display):
    """Others are faded. The normal force, 20 N, ends at (0.1, -0.2), the weight starts at (0, 0.2)."""
    content = scene(GRAVITY, support("Floor", 0, -0.5, width=10, height=0.6), mass("Bob", 0, 0.2, mass=2), duration=0.1)
    with App(display, content) as app:
        app.activate("show-forces")
        app.show_width()
        app.click_block("Bob")
        app.activate("play")
        wait(lambda: app.time() == 0.1 and not app.is_playing(), "the end")
        app.click("Equations", role="tab")
        books = app.find("image", "Work and energy, impulse and momentum")
        app.bring_into_view(books)
        watched = Watched(app, normal=app.area(0.06, -0.95, 0.14, -0.86), weight=app.area(-0.04, -0.55, 0.04, -0.45))
        for faded in ("normal", "weight"):
            scan(app, watched, seen(app, books), {faded})


def two_in_a_graph():
    graph = {"curves": [{"block": name, "quantity": "x"} for name in ("Bob", "Tom")]}
    return scene(mass("Bob", 0, 1), mass("Tom", 3, 1), spring("Spring", "Bob", "Tom", stiffness=5, rest_length=3),
                 duration=1, graphs=[graph])


def watch_two(app):
    """Runs to the end; the equations of both, and where their graph is."""
    app.activate("play")
    wait(lambda: app.time() == 1 and not app.is_playing(), "the end")
    app.show_width()
    app.click("Equations", role="tab")
    watched = Watched(app, **{name: part_of(app, re.compile(f"^{name}: m.* x.* equals$")) for name in ("Bob", "Tom")})
    return watched, app.box(app.find(None, re.compile("^Graph of ")))


def test_curve_lights_its_block(display):
    """Of two curves in one graph each lights up the equation of its own, and fades the other."""
    with App(display, two_in_a_graph()) as app:
        watched, box = watch_two(app)
        for name in ("Tom", "Bob"):
            scan(app, watched, box, {name})


def told(app, name):
    return (app.find(None, name).refreshed().description or "").split("; ")


def test_keys_on_the_canvas_light_terms(display):
    """Tab points at the block that it selects; Page Down goes from arrow to arrow, which it tells; both end with the
    focus on the canvas."""
    with App(display, sliding()) as app:
        app.activate("show-forces")
        watched = watch_terms(app)
        app.click_block("Bob")
        app.xdotool("mousemove", *app.at(*NOWHERE))
        app.press("Escape")
        watched.wait_lit()
        names = {"Gravity": "weight", "Floor (Normal force)": "normal", "Floor (Friction)": "friction"}
        heard = set()
        for _ in names:
            app.press("Next")
            wait(lambda: re.sub(r" [\d.]+ N$", "", told(app, "Canvas")[0]) in names.keys() - heard, "another arrow to be told")
            heard.add(re.sub(r" [\d.]+ N$", "", told(app, "Canvas")[0]))
            watched.wait_lit(names[re.sub(r" [\d.]+ N$", "", told(app, "Canvas")[0])])
        app.press("Escape")
        watched.wait_lit()
        check(told(app, "Canvas")[0].startswith("Shows "), "no arrow is told any more")
        for name, lit in (("Gravity", ["weight"]), ("Floor", ["normal", "friction"])):
            app.press("Tab")
            wait(lambda: any(words.startswith(name) for words in told(app, "Canvas")), f"{name} to be selected")
            watched.wait_lit(*lit)


def test_keys_in_a_graph_light_the_block_of_a_curve(display):
    with App(display, two_in_a_graph()) as app:
        watched, box = watch_two(app)
        app._click_at(box[0] + 30, box[1] + 8)
        app.xdotool("mousemove", *app.at(*NOWHERE))
        for key, name in (("Next", "Bob"), ("Next", "Tom"), ("Prior", "Bob")):
            app.press(key)
            watched.wait_lit(name)
            check(any(name in part for part in told(app, re.compile("^Graph of "))), "the curve is told")


if __name__ == "__main__":
    main()
