#!/usr/bin/python3
"""The page "Equations": its terms are read out, light up with their blocks, and have values; diagram and books."""
import os
import re

from harness import App, check, main, mass, scene, spring, support, wait
from harness import scenes

GRAVITY = {"type": "gravity", "name": "Gravity", "acceleration": 10}
WEIGHT = "Gravity: minus m times g"
PULL = re.compile("^Spring: plus T times")


def hanging():
    return scene(GRAVITY, support("Wall", 0, 3, solid=False), mass("Bob", 0, 0, mass=2),
                 spring("Spring", "Wall", "Bob", stiffness=25, rest_length=2))


def open_page(app):
    app.show_width()
    app.click("Equations", role="tab")
    return app.find("image", WEIGHT)


def test_terms_are_read_out(display):
    with App(display, hanging()) as app:
        open_page(app)
        app.find("image", "Bob: m times y double dot equals")
        app.find("image", PULL)
        app.find("image", "Spring: k times, L minus L nought")


def test_the_page_says_how_to_see_diagram_and_books(display):
    """They are of what is selected, and in their place stands what to do."""
    with App(display, hanging()) as app:
        open_page(app)
        app.find_text("Select bodies to see theirs alone")
        app.click_block("Bob")
        app.find("image", "Free-body diagram")
        wait(lambda: app.look("label", re.compile("^Select bodies")) is None, "the hint to go")


def test_pointing_at_a_term_lights_its_block(display):
    """And at a block its terms. The spring runs from (0, 3) to (0, 0)."""
    with App(display, hanging()) as app:
        open_page(app)
        term = app.find("image", PULL)
        box = app.box(term)
        inside = box[0], box[1], box[0] + box[2], box[1] + box[3]
        about = app.area(-0.5, 1, 0.5, 2)
        app.xdotool("mousemove", *app.at(2.5, -1))
        app.still_picture(-0.5, 1, 0.5, 2)
        dark, plain = (app.picture().cut(part) for part in (inside, about))
        app.xdotool("mousemove", *app.middle(term))
        wait(lambda: app.picture().cut(about) != plain, "a halo about the spring")
        app.xdotool("mousemove", *app.at(2.5, -1))
        wait(lambda: app.picture().cut(about) == plain, "it to go")
        wait(lambda: app.picture().cut(inside) == dark, "the term as it was")
        app.xdotool("mousemove", *app.at(0, 1.5))
        wait(lambda: app.picture().cut(inside) != dark, "the term to light up")


def test_long_equations_are_seen_whole(display):
    """The yo-yo's cord has definitions wider than the panel: they break, or become smaller."""
    disc = {"type": "disc", "name": "Yo-yo", "radius": 0.4, "position": [0.1, 1], "solid": False}
    cord = {"type": "cord", "name": "Cord", "ends": ["Yo-yo", "Finger"], "radius": 0.1}
    with App(display, scene(GRAVITY, support("Finger", 0, 2, solid=False), disc, cord)) as app:
        app.show_width()
        app.click("Equations", role="tab")
        long = app.find("image", re.compile("^Cord: .*arc ?tan", re.IGNORECASE))
        edge = app.box(app.find("image", re.compile("^Yo-yo: .* equals$")))[0]
        panel = app.box(app.find("tab", "Equations"))
        for node in (long, app.find("image", re.compile("^Cord: root of, max"))):
            x, _, width, _ = app.box(node)
            check(edge <= x and x + width <= panel[0] + panel[2] + 8, f"{node.name} is within the panel")


def test_normal_force_and_friction_are_told_apart(display):
    """Both terms are of one block: the tooltip says which one it is."""
    content = scene(GRAVITY, support("Floor", 0, -0.5, width=10, height=0.6, static_friction=0.5, dynamic_friction=0.4),
                    mass("Bob", 0, 0.2, mass=2, width=0.8, height=0.8))
    with App(display, content) as app:
        app.show_width()
        app.click("Equations", role="tab")
        term = app.find("image", re.compile("^Floor: .*\\bN\\b"))
        app.xdotool("mousemove", *app.middle(term))
        app.find("label", "Floor: normal force N")


def test_keys_reach_a_term_and_select_its_block(display):
    with App(display, hanging()) as app:
        open_page(app)
        app.click(app.find("image", "Bob: m times y double dot equals"))
        for _ in range(6):
            if app.find("image", WEIGHT).refreshed().has("focused"):
                break
            app.press("Tab")
        check(app.find("image", WEIGHT).refreshed().has("focused"), "Tab reaches the weight")
        app.press("Return")
        app.click("Properties", role="tab")
        app.wait_read("Appearance", "Name", "Gravity")


def test_values_beneath_the_terms(display):
    """2 kg under 10 m/s^2; the spring is longer by 1 m."""
    with App(display, hanging()) as app:
        open_page(app)
        app.click("Values", role="check box")
        for name, value in ((WEIGHT, "−20 N"), (PULL, "25 N")):
            wait(lambda: app.look("image", name, description=value), f"{name}: {value}")


def test_values_beneath_the_terms_of_a_moment(display):
    """A spring that is longer by 1 m pulls up at the rim, 0.5 m beside the middle: 25 N at 0.5 m, in two terms for one
    force, which stands beneath both of them."""
    wheel = {"type": "disc", "name": "Wheel", "position": [0, 0], "mass": 2, "radius": 0.5}
    content = scene(GRAVITY, support("Wall", 0.5, 3, solid=False), wheel,
                    spring("Spring", "Wall", {"block": "Wheel", "at": [0.5, 0]}, stiffness=25, rest_length=2))
    with App(display, content) as app:
        open_page(app)
        app.click("Values", role="check box")
        moments = re.compile("^Spring: .*r.* times .*T")
        wait(lambda: app.look("image", moments, description="together 12.5 N·m"), "the moment")


def test_selected_body_has_diagram_and_books(display):
    with App(display, hanging()) as app:
        open_page(app)
        check(app.look("image", "Free-body diagram") is None, "no diagram while nothing is selected")
        app.click_world(0.2, 0.2)
        app.click("Equations", role="tab")
        app.find("image", "Free-body diagram")
        app.activate("play")
        wait(lambda: app.time() > 0.2, "time to go on")
        app.activate("play")
        wait(lambda: app.tree.refresh(True) and any(node.name == "Work and energy, impulse and momentum"
                                                    and node.is_shown() for node in app.tree.refresh(True)), "books")


def test_values_are_of_the_very_moment(display):
    """A stiff spring's force changes by a tenth of itself between two samples. Beneath its term stands what the list of
    symbols has, which is of the very moment, as the diagram is."""
    content = scene(GRAVITY, support("Wall", 0, 3, solid=False), mass("Bob", 0, 0, mass=2),
                    spring("Spring", "Wall", "Bob", stiffness=2500, rest_length=2.9), duration=4, interval=1)
    with App(display, content) as app:
        open_page(app)
        app.click("Values", role="check box")
        app.activate("play")
        wait(lambda: app.time() > 3.9, "the end")
        for share in (0.41, 0.23):
            app.seek(share)

            def both():
                listed = [node.name for node in app.tree.refresh(True)
                          if node.role == "image" and re.fullmatch(r"Spring: (minus )?[\d.]+ N", node.name)]
                beneath = app.find("image", PULL).refreshed().description or ""
                found = re.search(r"([\d.]+) N$", beneath) if len(listed) == 1 else None
                return found and (float(listed[0].split()[-2]), float(found.group(1)))

            wait(lambda: both() and abs(both()[0] - both()[1]) <= 1e-3 * both()[0], "both to be the same")


def moment(app):
    """What the page says that it is of (s)."""
    label = app.look("label", re.compile(r"^t = [\d.]+ (s|ms)$"))
    number, unit = label.name.split()[2:] if label else ("-1", "s")
    return float(number) * (1e-3 if unit == "ms" else 1)


def test_page_follows_while_it_plays(display):
    """The bob's diagram turns into others without a stop, and the page tells the moment, which is never to come."""
    with App(display, scene(GRAVITY, support("Wall", 0, 3, solid=False), mass("Bob", 0, 0, mass=2),
                            spring("Spring", "Wall", "Bob", stiffness=25, rest_length=2), duration=600)) as app:
        open_page(app)
        app.click_world(0.2, 0.2)
        app.click("Equations", role="tab")
        box = app.box(app.find("image", "Free-body diagram"))
        inside = box[0], box[1], box[0] + box[2], min(box[1] + box[3], 700)
        app.activate("play")
        for _ in range(2):
            before, picture = moment(app), app.picture().cut(inside)
            wait(lambda: moment(app) > before, "a later moment")
            wait(lambda: app.picture().cut(inside) != picture, "another diagram")
            check(moment(app) <= app.time(), "no moment is shown before it has come")


def test_page_opened_while_it_plays_is_filled(display):
    """Its rows are more than one frame adds, and results of the run come in meanwhile: the last line is there while time
    goes on."""
    count = 28
    ends = [[f"M{i - 1}" if i else "Wall", f"M{i}"] for i in range(count)]
    chain = [block for i in range(count) for block in
             (mass(f"M{i}", i + 1, 0), spring(f"S{i}", *ends[i], rest_length=1),
              {"type": "damper", "name": f"D{i}", "ends": ends[i], "damping": 0.1},
              {"type": "motor", "name": f"F{i}", "ends": [f"M{i}"]})]
    with App(display, scene(GRAVITY, support("Wall", 0, 0, solid=False), *chain, duration=600)) as app:
        app.show_width()
        app.activate("play")
        wait(lambda: app.time() > 0, "time to go on")
        app.click("Equations", role="tab")
        app.find("image", re.compile(f"^M{count - 1}: y .* equals$"), patience=45)
        reached = app.time()
        wait(lambda: app.time() > reached, "time to go on")


def test_what_touches_on_the_way_has_its_terms(display):
    """A ball falls onto a floor and stays there: its equation has the normal force from then on, while time goes on."""
    with App(display, scene(GRAVITY, support("Floor", 0, -2, width=8, restitution=0), mass("Ball", 0, 0, mass=2),
                            duration=600)) as app:
        open_page(app)
        touch = re.compile("^Floor: plus N")
        check(app.look("image", touch) is None, "nothing touches at the start")
        app.activate("play")
        app.find("image", touch)
        reached = app.time()
        wait(lambda: app.time() > reached, "time to go on")


def test_form_without_equations(display):
    """A rod holds the bob: no matrices, and the page says so with Newton's equations; in angles there is one."""
    rod = {"type": "rod", "name": "Rod", "ends": ["Wall", "Bob"]}
    with App(display, scene(GRAVITY, support("Wall", 0, 3, solid=False), mass("Bob", 0, 0, mass=2), rod)) as app:
        open_page(app)
        app.choose_from(app.find("combo box", "Form of Equations"), "Angles")
        wait(lambda: app.look("image", WEIGHT) is None, "the equation in the angle")
        app.choose_from(app.find("combo box", "Form of Equations"), "Matrix")
        app.find("image", WEIGHT)
        app.find_text("These are Newton's")


def test_form_of_another_scene_is_not_complained_of(display):
    """Angles were chosen for a pendulum: a mass on a spring, opened next, has none, and is shown as Newton has it without a word
    of angles. In angles no term has a value of its own: the switch says so."""
    rod = {"type": "rod", "name": "Rod", "ends": ["Wall", "Bob"]}
    home = display.new_home()
    other = scenes.write(home, "spring.tinker.json", hanging())
    with App(display, scene(GRAVITY, support("Wall", 0, 3, solid=False), mass("Bob", 0, 0, mass=2), rod), home=home) as app:
        open_page(app)
        app.choose_from(app.find("combo box", "Form of Equations"), "Angles")
        wait(lambda: app.look("image", WEIGHT) is None, "the equation in the angle")
        wait(lambda: not app.find("check box", "Values").refreshed().has("sensitive"), "no values to switch on", 8)
        app.activate("open-recent", str(other))
        app.click("Equations", role="tab")
        app.find("image", PULL)
        check(app.look("label", re.compile("angles")) is None, "no word of angles")
        wait(lambda: app.find("check box", "Values").refreshed().has("sensitive"), "values to switch on")


def test_matrices(display):
    """Two masses between walls: m and 2 m on the diagonal of M; in K the sum of two springs, which lie on one line, and
    minus the one between the masses; C is of the damper alone. Each entry has its value, and lights up what it is of."""
    content = scene(support("Wall", 0, 0, solid=False), mass("One", 1, 0, mass=2), mass("Two", 3, 0, mass=4),
                    spring("Near", "Wall", "One", stiffness=25, rest_length=1),
                    spring("Far", "One", "Two", stiffness=50, rest_length=2),
                    {"type": "damper", "name": "Brake", "ends": ["One", "Two"], "damping": 3})
    with App(display, content) as app:
        app.show_width()
        app.click("Equations", role="tab")
        app.choose_from(app.find("combo box", "Form of Equations"), "Matrix")
        app.find("image", "K equals")
        for name, beneath in (("One: row 1, column 1: m", "2 kg"), ("Near: row 1, column 1: k", "together 75 N/m"),
                              ("Far: row 1, column 2: minus k", "−50 N/m"), ("Brake: row 2, column 2: c", "3 N·s/m")):
            found = re.compile(f"^{name}( one| two|$)")
            app.find("image", found)
            app.click("Values", role="check box")
            wait(lambda: app.look("image", found, description=beneath), f"{beneath} beneath {name}")
            app.click("Values", role="check box")
        term = app.find("image", re.compile("^Brake: row 1, column 1: "))
        about = app.area(1.6, -0.5, 2.4, 0.5)
        app.xdotool("mousemove", *app.at(2, 2))
        app.still_picture(1.6, -0.5, 2.4, 0.5)
        plain = app.picture().cut(about)
        app.bring_into_view(term)
        app.xdotool("mousemove", *app.middle(term))
        wait(lambda: app.picture().cut(about) != plain, "a halo about the damper")


def dark_span(picture, box):
    """The least and the greatest column with letters in this part of a picture."""
    x0, y0, x1, y1 = (int(edge) for edge in box)
    columns = [x for x in range(x0, x1) if any(sum(picture.pixel(x, y)[:3]) < 300 for y in range(y0, y1))]
    return columns[0], columns[-1]


def test_value_of_a_sum_is_beneath_all_of_it(display):
    """75 N/m is of k1 + k2 together: it stands in the middle beneath both, and a wheel over the matrix scrolls the page."""
    content = scene(support("Wall", 0, 0, solid=False), mass("One", 1, 0, mass=2), mass("Two", 3, 0, mass=4),
                    spring("Near", "Wall", "One", stiffness=25, rest_length=1),
                    spring("Far", "One", "Two", stiffness=50, rest_length=2))
    with App(display, content) as app:
        app.show_width()
        app.click("Equations", role="tab")
        app.choose_from(app.find("combo box", "Form of Equations"), "Matrix")
        app.click("Values", role="check box")
        near = app.find("image", re.compile("^Near: row 1, column 1: "))
        wait(lambda: near.refreshed().description == "together 75 N/m", "the value")
        app.xdotool("mousemove", *app.at(2, 2))
        first, last = app.settled(near), app.settled(app.find("image", re.compile("^Far: row 1, column 1: ")))
        bottom = first[1] + first[3]
        picture = app.picture()
        left, right = dark_span(picture, (first[0], bottom - 11, last[0] + last[2], bottom))
        middle = (first[0] + last[0] + last[2]) / 2
        check(abs((left + right) / 2 - middle) < 4, f"the value from {left} to {right} about {middle}")
        keep = os.environ.get("TINKER_PICTURES")
        if keep:
            picture.write_png(f"{keep}/matrix.png")
        app.xdotool("mousemove", *app.middle(near))
        app.xdotool("click", "--repeat", "3", "5")
        wait(lambda: app.box(near)[1] < first[1] - 20, "the page to scroll")


def test_value_is_never_cut(display):
    """1.2345e-5 kg under 10 m/s^2: its four digits and its size have room, whatever that takes."""
    with App(display, scene(GRAVITY, mass("Bob", 0, 0, mass=1.2345e-5))) as app:
        open_page(app)
        app.click("Values", role="check box")
        weight = app.find("image", WEIGHT)
        wait(lambda: weight.refreshed().description in ("−0.0001234 N", "−0.0001235 N"), "the weight")
        wait(lambda: app.box(weight)[2] > 74, "room for it")


def test_rounding_is_no_force(display):
    """A bob hangs on a rod that leans by rounding alone: across it pulls with 0 N, as diagram and books say."""
    content = scene(GRAVITY, support("Wall", 0, 3, solid=False), mass("Bob", 1e-15, 0, mass=2),
                    {"type": "rod", "name": "Rod", "ends": ["Wall", "Bob"]})
    with App(display, content) as app:
        open_page(app)
        app.click("Values", role="check box")
        across = re.compile("^Rod: ")
        wait(lambda: [node.description for node in app.tree.refresh(True) if node.role == "image" and across.match(node.name)
                      and node.description][:2] == ["0 N", "20 N"], "0 N across and 20 N up")


def test_list_of_values_follows_while_it_plays(display):
    """The moment over the list of values is that at the top of the page, and is never that of the start for long."""
    content = scene(support("Wall", 0, 0, solid=False), mass("Bob", 1, 0, mass=2),
                    spring("Spring", "Wall", "Bob", stiffness=25, rest_length=0.5), duration=600)
    with App(display, content) as app:
        app.show_width()
        app.click("Equations", role="tab")
        app.find("image", re.compile("^Spring: "))

        def listed():
            label = app.look("label", re.compile(r"^at t = [\d.]+ s$"))
            return float(label.name.split()[3]) if label else -1

        wait(lambda: listed() == 0, "the values of the start")
        app.activate("play")
        for _ in range(3):
            before = listed()
            wait(lambda: listed() > before, "later values")
        check(listed() <= app.time(), "no moment is shown before it has come")


def row_of_masses(count):
    """Springs hold them in a row."""
    names = [f"M{i}" for i in range(count)]
    blocks = [support("Wall", 0, 0, solid=False)]
    blocks += [mass(name, 1 + i, 0, mass=2) for i, name in enumerate(names)]
    blocks += [spring(f"S{i}", before, name, stiffness=25, rest_length=0.9)
               for i, (before, name) in enumerate(zip(["Wall"] + names, names))]
    return scene(*blocks, width=count + 2)


def test_a_form_that_was_refused_plays(display):
    with App(display, row_of_masses(2)) as app:
        app.show_width()
        app.click("Equations", role="tab")
        app.choose_from(app.find("combo box", "Form of Equations"), "Angles")
        app.find_text("These are Newton's")
        app.click("Play")
        wait(lambda: app.time() > 1, "a second of it")
        app.find_text("These are Newton's")


def test_blocks_go_while_their_rows_are_added(display):
    with App(display, row_of_masses(25)) as app:
        app.show_width()
        app.click("Equations", role="tab")
        for _ in range(6):
            app.find("image", re.compile("^M0: "))
            app.activate("select-all")
            app.activate("delete")
            app.activate("undo")
        app.find("image", re.compile("^M24: "))


def test_numbers_among_matrices_are_of_the_moment(display):
    with App(display, row_of_masses(2)) as app:
        app.show_width()
        app.click("Equations", role="tab")
        app.choose_from(app.find("combo box", "Form of Equations"), "Matrix")
        app.find("image", "K equals")
        app.click("Play")
        wait(lambda: app.time() > 1, "a second of it")
        app.click("Pause")
        app.seek(0.05)

        def told():
            label = app.look("label", re.compile("^at t = "))
            return label is not None and abs(float(label.name.split()[3]) - app.time()) < 0.01

        wait(told, "the values of the moment that is shown")


def test_pattern_of_many_coordinates(display):
    """Twelve masses in a chain with one end free: 2 k on the diagonal but for the last, -k beside it."""
    masses = [mass(f"M{i}", i + 1, 0) for i in range(12)]
    springs = [spring(f"S{i}", f"M{i - 1}" if i else "Wall", f"M{i}", stiffness=50, rest_length=1) for i in range(12)]
    with App(display, scene(support("Wall", 0, 0, solid=False), *masses, *springs, width=16)) as app:
        app.click("Equations", role="tab")
        app.choose_from(app.find("combo box", "Form of Equations"), "Matrix")
        app.find("label", "K is tridiagonal, 12 × 12, with 34 entries")
        app.find_text("on the diagonal, 11 of 12, 100 N/m")
        app.find_text("beside it, −50 N/m")


if __name__ == "__main__":
    main()
