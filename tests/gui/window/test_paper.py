#!/usr/bin/python3
"""The canvas as a picture and printed; full screen for a projector."""
import re
import zlib

from harness import App, check, check_close, check_equal, main, mass, scene, spring, support, wait

GRAPHS = [{"block": "Bob", "quantity": "y", "place": [1, 3], "size": [3.5, 2.2]}, {"block": "Bob", "quantity": "vy"}]
METER = {"block": "Bob", "quantity": "y", "kind": "number", "place": [-4.5, 3]}
BOB = scene(support("Roof", 0, 4, orientation="180 deg"), mass("Bob", 0, 1), spring("Coil", "Roof", "Bob"), duration=4, graphs=GRAPHS,
            meters=[METER])


def test_picture_of_the_canvas(display):
    """In each format; as large as the canvas is."""
    with App(display, BOB) as app:
        app.show_width()
        _, _, width, height = app.canvas_box()
        for name in ("scene.png", "scene.svg", "scene.pdf"):
            app.press("ctrl+shift+p")
            app.save_dialog("Save Picture", app.home / name)
            wait((app.home / name).exists, name)
        head = (app.home / "scene.png").read_bytes()[:24]
        size = int.from_bytes(head[16:20], "big"), int.from_bytes(head[20:24], "big")
        check_close(size[0], width, 2, "width (px)")
        check_close(size[1], height, 2, "height (px)")
        check("<svg" in (app.home / "scene.svg").read_text()[:200], "a drawing")
        check((app.home / "scene.pdf").read_bytes().startswith(b"%PDF"), "a document")


def test_scene_is_not_written_over(display):
    """Whoever takes the scene's own name for its picture is told."""
    with App(display, BOB) as app:
        before = app.file.read_bytes()
        link = app.home / "link.png"
        link.symlink_to(app.file)
        app.press("ctrl+shift+p")
        app.save_dialog("Save Picture", link)
        app.find("label", "The Image Was Not Saved")
        check_equal(app.file.read_bytes(), before, "the scene")
        app.press("Escape")


def pages(document):
    """How many a PDF has: what its page tree tells, which may stand in a compressed part."""
    parts = [document]
    for part in re.findall(rb"stream\r?\n(.*?)endstream", document, re.S):
        try:
            parts.append(zlib.decompressobj().decompress(part))
        except zlib.error:
            pass
    return max(int(count) for part in parts for count in re.findall(rb"/Count (\d+)", part))


def test_printed_to_a_file(display):
    """Two pages: the canvas, and its graphs."""
    with App(display, BOB) as app:
        app.press("ctrl+p")
        dialog = app.find("dialog", "Print")
        app.click("Print to File", role=None, inside=dialog)
        wait(lambda: app.look("button", "Print", inside=dialog).has("sensitive"), "a printer to be chosen")
        app.click("Print", inside=dialog)
        file = wait(lambda: next(iter(app.home.rglob("*.pdf")), None), "the file")
        wait(lambda: file.read_bytes().rstrip().endswith(b"%%EOF"), "all of it")
        check_equal(pages(file.read_bytes()), 2, "pages")


def test_large_for_a_projector(display):
    """Nothing but the canvas and the play bar, until Escape."""
    with App(display, scene(mass("H", 0, 0), width=10)) as app:
        _, _, width, height = app.canvas_box()
        app.press("F11")
        wait(lambda: app.canvas_box()[2] > width + 200 and app.canvas_box()[3] > height, "a larger canvas")
        app.find("button", "Play")
        app.press("Escape")
        wait(lambda: app.canvas_box()[2:] == (width, height), "the canvas as it was")


if __name__ == "__main__":
    main()
