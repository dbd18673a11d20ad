#!/usr/bin/env python3
"""All figures of a build in one table: what S1 to S6, S8 and S9 take beside their floors, reading and running a large scene,
starting, memory, and the window with 5000 blocks.

Usage: figures.py [BUILD] [--json FILE] [--before FILE]

BUILD is the build folder ("build"). --json keeps the figures; --before puts those of such a file beside them. The window is left out
where there is no xvfb-run. Times are the least of several batches: take both tables on a quiet machine, or in turns."""
import argparse, json, os, pathlib, shutil, subprocess, sys, tempfile, time


def run(program, *options, display=False):
    """What a benchmark program wrote as JSON."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "figures.json")
        command = ["xvfb-run", "-a"] if display else []
        environment = dict(os.environ, GSK_RENDERER="cairo", XDG_CACHE_HOME=folder,
                           TINKER_PLUGIN_PATH=str(program.parents[2] / "plugins"))
        command += [program, "--json", path, *options]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=environment)
        report = json.loads(pathlib.Path(path).read_text())
    if not report["steps"] + report["figures"]:
        sys.exit("figures.py: %s took no figures" % program)
    return report


def step_row(step):
    elements = step["elements"]
    return {"figure": "%s, %s" % (step["scene"], step["method"]), "unit": "ns" if elements == 1 else "ns an element",
            "value": step["ns_per_step_least"] / elements, "floor": step["floor_ns_per_step_least"] / elements,
            "goal": step["goal_ns_per_element"]}


def figure_row(figure):
    return {"figure": "%s: %s" % (figure["scene"], figure["figure"]), "unit": figure["unit"], "value": figure["value"],
            "floor": None, "goal": figure["at_most"]}


def measure(folder):
    rows = [step_row(step) for step in run(folder / "bench-steps")["steps"]]
    rows += [figure_row(figure) for figure in run(folder / "bench-program")["figures"]]
    window = folder / "bench-window"
    if window.exists() and shutil.which("xvfb-run"):
        rows += [figure_row(figure) for figure in run(window, "--only", "5000 blocks", display=True)["figures"]]
    else:
        print("no window: bench-window or xvfb-run is missing", file=sys.stderr)
    return rows


def text(value):
    return "" if value is None else "%.4g" % value


def print_table(rows, before):
    known = {row["figure"]: row["value"] for row in before}
    heads = ["figure", "unit"] + (["before", "now", "now/before"] if known else ["now"]) + ["floor", "now/floor", "goal"]
    print("| " + " | ".join(heads) + " |\n|" + " --- |" * len(heads))
    for row in rows:
        value, floor, old = row["value"], row["floor"], known.get(row["figure"])
        cells = [row["figure"], row["unit"]]
        cells += [text(old), text(value), text(old and value / old)] if known else [text(value)]
        cells += [text(floor), text(floor and value / floor), text(row["goal"])]
        print("| " + " | ".join(cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", default="build", type=pathlib.Path)
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--before", type=pathlib.Path)
    options = parser.parse_args()
    before = json.loads(options.before.read_text())["rows"] if options.before else []
    load = [os.getloadavg()[0]]
    rows = measure(options.build.resolve() / "tests" / "benchmarks")
    load.append(os.getloadavg()[0])
    if options.json:
        options.json.write_text(json.dumps({"taken": time.strftime("%F %T"), "load": load, "rows": rows}, indent=1))
    print_table(rows, before)
    print("\nLoad of the machine, %d processors: %.1f before, %.1f after." % (os.cpu_count(), *load))


if __name__ == "__main__":
    main()
