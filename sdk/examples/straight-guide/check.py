"""The straight guide against closed forms, a quadrature and the car axis. Run by `meson test`."""
import csv
import io
import json
import math
import os
import subprocess
import unittest

G = 9.81


def tinker(verb, scene, *options):
    command = [os.environ["TINKER"], verb, "-", "--plugins", os.environ["PLUGINS"], *options]
    return subprocess.run(command, input=json.dumps(scene), capture_output=True, text=True, check=False)


def run(scene, columns, **options):
    """The rows of the record, as {time: {column: value}}."""
    done = tinker("run", scene, "--columns", columns, "--csv", "-",
                  *(text for key, value in options.items() for text in ("--" + key, value)))
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    rows = csv.DictReader(io.StringIO(done.stdout))
    table = [{name.split(" [")[0]: float(value) for name, value in row.items()} for row in rows]
    return {row["time"]: row for row in table}


def cart_and_pole(cart, angle):
    """The bundled scene with a cart of this mass, let go at this angle from below."""
    with open("straight-guide.tinker.json", encoding="utf-8") as file:
        scene = json.load(file)
    blocks = {block["name"]: block for block in scene["blocks"]}
    blocks["Cart"]["mass"] = cart
    blocks["Bob"]["position"] = [math.sin(angle), -math.cos(angle)]
    return scene


class Cart(unittest.TestCase):
    def swing_time(self, cart, bob, start, angle):
        """From start at rest to angle: energy and horizontal momentum are kept, so
        angle'^2 = 2 g (cos angle - cos start) / (l (1 - bob cos^2 / (cart + bob))); a quadrature of 1 / angle'
        with angle = start cos(s), by the trapezoidal rule on a smooth integrand with Richardson's extrapolation."""
        def integrand(s):
            at = start * math.cos(s)
            fall = 2 * math.sin((start + at) / 2) * math.sin((start - at) / 2)
            inertia = 1 - bob / (cart + bob) * math.cos(at) ** 2
            if s == 0:
                return math.sqrt(inertia * start / (G * math.sin(start)))
            return start * math.sin(s) * math.sqrt(inertia / (2 * G * fall))

        end, table = math.acos(angle / start), []
        for level in range(4, 14):
            n = 2**level
            inside = sum(integrand(end * k / n) for k in range(1, n))
            row = [end / n * (integrand(0) / 2 + inside + integrand(end) / 2)]
            for k in range(1, len(table[-1]) + 1 if table else 0):
                row.append(row[-1] + (row[-1] - table[-1][k - 1]) / (4**k - 1))
            table.append(row[:6])
        return table[-1][-1]

    def test_swing(self):
        """The carts of 0.5 kg and, nearly without mass, of 1 g and 1 mg, when their poles pass several angles."""
        start, bob = math.radians(60), 2.0
        for cart in (0.5, 1e-3, 1e-6):
            scene = cart_and_pole(cart, start)
            for angle in (math.radians(50), math.radians(20), math.radians(-45)):
                time = self.swing_time(cart, bob, start, angle)
                row = run(scene, "Bob.x,Bob.y,Cart.x,Cart.y,Guide.error", at=repr(time), tolerance="1e-12")[time]
                x = bob / (cart + bob) * math.sin(start)
                self.assertAlmostEqual(row["Cart.x"], x - bob / (cart + bob) * math.sin(angle), delta=2e-8)
                self.assertAlmostEqual(row["Bob.x"], x + cart / (cart + bob) * math.sin(angle), delta=2e-8)
                self.assertAlmostEqual(row["Bob.y"], -math.cos(angle), delta=2e-8)
                self.assertAlmostEqual(row["Cart.y"], 0, delta=1e-12)
                self.assertAlmostEqual(row["Guide.error"], 0, delta=1e-12)

    def test_small_swing(self):
        """w^2 = (1 + bob / cart) g / l."""
        for cart in (0.5, 1e-3):
            done = tinker("modes", cart_and_pole(cart, 0.0), "--json", "-")
            self.assertEqual(done.returncode, 0, done.stderr)
            rate = max(mode["angular_frequency"] for mode in json.loads(done.stdout)["modes"])
            self.assertAlmostEqual(rate / math.sqrt((1 + 2 / cart) * G), 1, delta=1e-6)


class Incline(unittest.TestCase):
    def test_slides(self):
        """Down a slope of 30 deg: g sin(30 deg), and the guide carries m g cos(30 deg)."""
        scene = {"tinker": 1, "run": {"duration": 1, "interval": 0.1}, "blocks": [
            {"type": "gravity"}, {"type": "support", "name": "Wall", "solid": False},
            {"type": "mass", "name": "Bead", "mass": 2, "position": [0, 0]},
            {"type": "straight-guide", "name": "Guide", "ends": [
                "Bead", "Wall", {"block": "Wall", "at": [-math.cos(math.pi / 6), -0.5]}]}]}
        for t, row in run(scene, "Guide.along,Guide.force,Bead.ay").items():
            self.assertAlmostEqual(row["Guide.along"], G / 4 * t * t, delta=1e-12)
            self.assertAlmostEqual(row["Guide.force"], -2 * G * math.sqrt(0.75), delta=1e-10)
            self.assertAlmostEqual(row["Bead.ay"], -G / 4, delta=1e-10)


class Turning(unittest.TestCase):
    def test_bead_on_a_turning_line(self):
        """On a line that turns with w about a point of it a bead goes out as r = cosh(w t), pushed with 2 m w r'."""
        w = 1.5
        blocks = [{"type": "support", "name": "Hub", "solid": False, "position": [0, 0]},
                  {"type": "support", "name": "Rim", "solid": False, "position": [0, 0]},
                  {"type": "mass", "name": "Bead", "mass": 2, "position": [1, 0], "velocity": [0, w]},
                  {"type": "support-motion", "ends": ["Rim"], "waveform": {"expression": f"2*cos({w}*t)"}},
                  {"type": "support-motion", "ends": ["Rim"], "waveform": {"expression": f"2*sin({w}*t)"},
                   "angle": "90 deg"},
                  {"type": "straight-guide", "name": "Guide", "ends": ["Bead", "Hub", "Rim"]}]
        scene = {"tinker": 1, "run": {"duration": 2, "interval": 0.1, "tolerance": 1e-12}, "blocks": blocks}
        for t, row in run(scene, "Guide.along,Guide.force,Guide.error").items():
            self.assertAlmostEqual(row["Guide.along"], math.cosh(w * t), delta=1e-8)
            self.assertAlmostEqual(row["Guide.force"], 2 * 2 * w * w * math.sinh(w * t), delta=1e-6)
            self.assertAlmostEqual(row["Guide.error"], 0, delta=1e-12)

    def test_line_between_bodies(self):
        """A guide between two free bodies exerts no net force and no moment."""
        masses = {"A": 1.0, "B": 2.0, "Bead": 0.5}
        places = {"A": ([0, 0], [0, -1]), "B": ([2, 1], [0.5, 1]), "Bead": ([0.5, 0.25], [0.1, 0.2])}
        blocks = [{"type": "mass", "name": n, "mass": m, "position": places[n][0], "velocity": places[n][1]}
                  for n, m in masses.items()]
        blocks.append({"type": "straight-guide", "name": "Guide", "ends": ["Bead", "A", "B"]})
        scene = {"tinker": 1, "run": {"duration": 3, "interval": 0.1, "tolerance": 1e-12}, "blocks": blocks}
        start = None
        for row in run(scene, ",".join(f"{n}.{c}" for n in masses for c in ("x", "y", "vx", "vy"))).values():
            now = [sum(m * row[n + ".vx"] for n, m in masses.items()), sum(m * row[n + ".vy"] for n, m in masses.items()),
                   sum(m * (row[n + ".x"] * row[n + ".vy"] - row[n + ".y"] * row[n + ".vx"]) for n, m in masses.items()),
                   sum(m / 2 * (row[n + ".vx"] ** 2 + row[n + ".vy"] ** 2) for n, m in masses.items())]
            start = start or now
            for value, first in zip(now, start):
                self.assertAlmostEqual(value, first, delta=1e-9)


class CarAxis(unittest.TestCase):
    # xl, yl, xr, yr and their rates at t = 3: Test Set for IVP Solvers, problem CAXIS
    PUBLISHED = {"L.x": 0.493455784275402809122e-1, "L.y": 0.496989460230171153861, "R.x": 0.104174252488542151681e1,
                 "R.y": 0.373911027265361256927, "L.vx": -0.770583684040972357970e-1, "L.vy": 0.744686658723778553466e-2,
                 "R.vx": 0.175568157537232222276e-1, "R.vy": 0.770341043779251976443}

    def test_end(self):
        """Masses eps^2 M / 2, springs of 1 N/m, g = 1; the left one moves across the line between the wheels."""
        mass = 1e-4 * 10 / 2
        inwards, height = "sqrt(1 - (0.1*sin(10*t))^2)", "0.1*sin(10*t)"

        def moved(support, x, y):
            return [{"type": "support-motion", "ends": [support], "waveform": {"expression": x}},
                    {"type": "support-motion", "ends": [support], "waveform": {"expression": y}, "angle": "90 deg"}]

        blocks = [{"type": "gravity", "acceleration": 1},
                  {"type": "support", "name": "LeftWheel", "solid": False, "position": [0, 0]},
                  {"type": "support", "name": "RightWheel", "solid": False, "position": [0, 0]},
                  {"type": "support", "name": "Above", "solid": False, "position": [0, 0]},
                  *moved("RightWheel", inwards, height), *moved("Above", "-" + height, inwards),
                  {"type": "mass", "name": "L", "mass": mass, "position": [0, 0.5], "velocity": [-0.5, 0]},
                  {"type": "mass", "name": "R", "mass": mass, "position": [1, 0.5], "velocity": [-0.5, 0]},
                  {"type": "spring", "ends": ["LeftWheel", "L"], "stiffness": 1, "rest_length": 0.5},
                  {"type": "spring", "ends": ["RightWheel", "R"], "stiffness": 1, "rest_length": 0.5},
                  {"type": "rod", "ends": ["L", "R"], "length": 1},
                  {"type": "straight-guide", "name": "Guide", "ends": ["L", "LeftWheel", "Above"]}]
        scene = {"tinker": 1, "run": {"duration": 3, "tolerance": 1e-13}, "blocks": blocks}
        end = run(scene, ",".join(self.PUBLISHED), at="3")[3.0]
        for name, published in self.PUBLISHED.items():
            self.assertAlmostEqual(end[name], published, delta=1e-9, msg=name)


if __name__ == "__main__":
    unittest.main()
