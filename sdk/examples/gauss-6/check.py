"""The order and the stability function of the method. Run by `meson test`."""
import csv
import io
import json
import math
import os
import subprocess
import unittest


def tinker(scene, *options):
    command = [os.environ["TINKER"], "run", "-", "--plugins", os.environ["PLUGINS"], *options]
    return subprocess.run(command, input=json.dumps(scene), capture_output=True, text=True, check=False)


def run(scene, columns, **options):
    """The rows of the record, as {time: {column: value}}."""
    done = tinker(scene, "--columns", columns, "--csv", "-",
                  *(text for key, value in options.items() for text in ("--" + key, value)))
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    rows = csv.DictReader(io.StringIO(done.stdout))
    table = [{name.split(" [")[0]: float(value) for name, value in row.items()} for row in rows]
    return {row["time"]: row for row in table}


def sn(u, m):
    """Jacobi's elliptic function by descending Landen transformation (Abramowitz and Stegun, 16.4)."""
    a, b, c = [1.0], [math.sqrt(1.0 - m)], [math.sqrt(m)]
    while c[-1] > 1e-9:  # the next would be its square
        c.append((a[-1] - b[-1]) / 2)
        a, b = a + [(a[-1] + b[-1]) / 2], b + [math.sqrt(a[-1] * b[-1])]
    phi = 2 ** (len(a) - 1) * a[-1] * u
    for n in range(len(a) - 1, 0, -1):
        phi = (phi + math.asin(c[n] / a[n] * math.sin(phi))) / 2
    return math.sin(phi), math.pi / (2 * a[-1])


def oscillator(**changed):
    """The bundled scene without its damper."""
    with open("gauss-6.tinker.json", encoding="utf-8") as file:
        scene = json.load(file)
    scene["blocks"] = [block for block in scene["blocks"] if block["type"] != "damper"]
    scene["run"].update(changed)
    return scene


class Order(unittest.TestCase):
    def orders(self, error_at, steps):
        errors = [error_at(step) for step in steps]
        return [math.log2(coarse / fine) for coarse, fine in zip(errors, errors[1:])]

    def test_damped_oscillator(self):
        """x = 2 + 0.5 e^(-t/5) (cos wt + sin(wt) / 5w), w^2 = 4 - 1/25, at samples that fall between the steps, too."""
        with open("gauss-6.tinker.json", encoding="utf-8") as file:
            scene = json.load(file)
        w = math.sqrt(4 - 0.04)

        def error_at(step):
            return max(abs(row["Mass.x"] - 2 - 0.5 * math.exp(-t / 5) * (math.cos(w * t) + math.sin(w * t) / (5 * w)))
                       for t, row in run(scene, "Mass.x", step=repr(step)).items())

        for order in self.orders(error_at, (0.4, 0.2, 0.1)):
            self.assertAlmostEqual(order, 6, delta=0.3)

    def test_pendulum_on_a_rod(self):
        """Let go at 90 deg: sin(angle / 2) = k sn(K - w t), k = sin(45 deg)."""
        g, k = 9.81, math.sqrt(0.5)
        blocks = [{"type": "gravity", "acceleration": g}, {"type": "support", "name": "Pivot", "solid": False},
                  {"type": "mass", "name": "Bob", "position": [1, 0]}, {"type": "rod", "ends": ["Pivot", "Bob"]}]
        scene = {"tinker": 1, "run": {"duration": 2, "interval": 0.07, "method": "gauss-6"}, "blocks": blocks}

        def error_at(step):
            worst = 0.0
            for t, row in run(scene, "Bob.x,Bob.y", step=repr(step)).items():
                half = math.asin(k * sn(sn(0.0, k * k)[1] - math.sqrt(g) * t, k * k)[0])
                worst = max(worst, math.hypot(row["Bob.x"] - math.sin(2 * half), row["Bob.y"] + math.cos(2 * half)))
            return worst

        for order in self.orders(error_at, (0.1, 0.05, 0.025)):
            self.assertAlmostEqual(order, 6, delta=0.6)


class Stability(unittest.TestCase):
    def test_stability_function(self):
        """A step multiplies x - 2 + i v / w by R(-i h w), R(z) = P(z) / P(-z), P(z) = 1 + z/2 + z^2/10 + z^3/120, for steps
        of any length below the limit: 200 of them, to rounding."""
        def p(z):
            return 1 + z / 2 + z * z / 10 + z**3 / 120

        for step in (0.5, 1.0, 1.75):
            z = -2j * step
            scene = oscillator(duration=200 * step, interval=step)
            record = run(scene, "Mass.x,Mass.vx", step=repr(step))
            self.assertEqual(len(record), 201)
            for n, row in enumerate(record.values()):
                expected = 0.5 * (p(z) / p(-z)) ** n
                self.assertAlmostEqual(row["Mass.x"] - 2, expected.real, delta=1e-11)
                self.assertAlmostEqual(row["Mass.vx"], 2 * expected.imag, delta=2e-11)

    def test_too_long_a_step(self):
        """Where the iteration cannot converge the run says so."""
        done = tinker(oscillator(duration=20, interval=1), "--step", "3")
        self.assertEqual(done.returncode, 1)
        self.assertIn("a smaller step", done.stderr)


if __name__ == "__main__":
    unittest.main()
