#!/usr/bin/env python3
"""Every symbol that the equations of a bundled scene print is explained beneath them: with its value, its unit, and what
it is. Reads the program's pages as a reader does: in text, LaTeX and MathML each by its own signs, and the trees of JSON.

check-equation-symbols.py TINKER SCENES, a program and the folder of the bundled scenes."""
import concurrent.futures
import glob
import html
import json
import os
import re
import subprocess
import sys
import unicodedata

FORMS = ["newton", "matrix", "angles"]
FUNCTIONS = {"sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp", "log", "sqrt", "abs",
             "min", "max", "sign", "floor", "mod", "pow", "step", "if", "else", "pi", "hypot"}
NUMBER = r"[−-]?(?:\d+(?:\.\d+)?(?:e[+-]?\d+)?|2?π|(?:2 )?\\pi )"


def page(tinker, scene, form, format_, *more):
    words = [tinker, "equations", scene, "--form", form, "--as", format_, *more]
    return unicodedata.normalize("NFC", subprocess.run(words, check=True, capture_output=True, text=True).stdout)


# Each reader answers rows of (symbols on the left, left is one symbol, symbols on the right, the value or None, comment).
def mathml_symbols(text):
    text = re.sub(r"<mi>[^<]*</mi><mo>&#x2061;</mo>", "", text).replace("<mi>π</mi>", "")
    text = re.sub(r"<msubsup>(<mi>[^<]*</mi><mrow>.*?</mrow>)<mrow>.*?</mrow></msubsup>", r"<msub>\1</msub>", text)
    return re.findall(r"<msub><mi>[^<]*</mi><mrow>.*?</mrow></msub>|<mi>[^<]*</mi>", text)


def mathml_rows(text):
    row = (r"<tr><td><math>(.*?)</math></td><td><math displaystyle=\"true\"><mrow><mo>=</mo>(.*?)</mrow></math></td>"
           r"<td>(.*?)</td></tr>")
    text = re.sub(r'<mover>(<mi>.*?</mi>)<mo>.</mo></mover>', r"\1", text)
    for left, right, comment in re.findall(row, text):
        plain = html.unescape(re.sub(r"<msup><mn>10</mn><mn>(-?\d+)</mn></msup>", r"10^\1", right))
        plain = re.sub(r"<[^>]*>", "", plain)
        names = mathml_symbols(left)
        value = re.fullmatch(NUMBER + r"(·10\^-?\d+)?(\xa0.*)?", plain)
        yield names, left in names, mathml_symbols(right), value and plain, html.unescape(comment)


def latex_symbols(text):
    text = re.sub(r"\\text\{.*?\}(?!\})", "", re.sub(r"_\{((?:[^{}]|\{[^{}]*\})*)\}", lambda m: "_{" + m.group(1)
                  .replace("\\text", "\\name") + "}", text))
    return re.findall(r"\{((?:\\[a-zA-Z]+|[^\W\d]|\\mathrm\{[^{}]*\})\}(?:_\{(?:[^{}]|\{[^{}]*\})*\})?)", text)


def latex_rows(text):
    for block in re.findall(r"\\begin\{align\*\}\n(.*?)\\end\{align\*\}", text, re.S):
        joined = re.sub(r" \\\\\n&\\qquad\{\}", "", re.sub(r"\\right\.|\\left\.", "", block))
        joined = re.sub(r"\\scalebox\{[\d.]*\}\{\$\\displaystyle (.*?)\$\}", r"\1", joined)
        for row in joined.split(" \\\\\n"):
            row = re.sub(r"\\parbox\[t\]\{\d+pt\}\{\\raggedright ", r"\\text{", row.strip())
            formula, _, comment = row.partition(" && \\text{")
            left, _, right = formula.partition("&")
            right = right.lstrip("= ")
            value = re.fullmatch(NUMBER + r"(\\cdot 10\^\{-?\d+\})?(\\,\\text\{.*\})?", right)
            one = re.fullmatch(r"(?:\\d?dot)?\{(?:\\[a-zA-Z]+|[^\W\d]|\\mathrm\{[^{}]*\})\}(_\{.*\})?", left.strip())
            yield latex_symbols(left), bool(one), latex_symbols(right), value and right, comment.rstrip("}")


def text_rows(text):
    found, left = [], ""
    for line in text.splitlines():
        match = re.match(r"  +(.*?) = (.*?)(?:   +(.*))?$", line)
        if match:
            found.append([match.group(1), match.group(2), match.group(3) or ""])
        elif line.startswith("    ") and found:
            found[-1][2] = line.strip()
    # one symbol, which may have a space in its index, but is no product with an acceleration in it, and no sum
    dotted = lambda s: re.search("[\u0307\u0308]", unicodedata.normalize("NFD", s)) is not None
    named = [left for left, right, comment in found if (comment or re.match(NUMBER + r"( [^ ]*)?$", right))
             and not left[0].isdigit() and not (" " in left and dotted(left)) and not re.search(r"[+²()]", left)]
    dotless = lambda s: unicodedata.normalize("NFC", re.sub("[\u0307\u0308]", "", unicodedata.normalize("NFD", s)))
    shape = "|".join(re.escape(name) for name in sorted(set(named) | {dotless(n) for n in named}, key=len, reverse=True))

    def symbols(formula):
        amount = r"(^|[+−=] ?)" + NUMBER + r"( [a-zA-Z/·²³ ]+)?$"
        formula = re.sub("[⁰²³¹⁴-⁹]", " ", re.sub(amount, "", dotless(formula)))
        known = re.findall(rf"(?<!\w)(?:{shape})(?![\w])", formula)
        rest = re.sub(rf"(?<!\w)(?:{shape})(?![\w])", " ", formula)
        others = {word for word in re.findall(r"[^\W\d_][\w]*", rest)} - FUNCTIONS - {"π"}
        return known + sorted(others)

    for left, right, comment in found:
        value = re.fullmatch(NUMBER + r"( .*)?", right) if not re.search(r" [+−] | \(", right) else None
        yield symbols(left), left in named, [] if value else symbols(right), value and right, comment


def is_of_matrices(name):
    """M, C, K, the vector f, and entries such as K_i,i: the page has them written out, or tells their pattern."""
    plain = re.sub(r"<[^>]*>|[{}\\\\]|name", "", name)
    return re.fullmatch(r"[MCKf](_?i,i(±\d+)?)?", plain) is not None


READERS = {"mathml": mathml_rows, "latex": latex_rows, "text": text_rows}


def unexplained(rows, form):
    rows = list(rows)
    if form == "matrix":  # the pattern of a matrix has its values behind it; its k stands for many
        rows = [row for row in rows if not any(is_of_matrices(name) for name in row[0])]
    used = {name for left, _, right, value, _ in rows for name in [*left, *([] if value else right)]}
    valued = {left[0] for left, one, _, value, _ in rows if one and value and len(left) == 1}
    told = {left[0] for left, one, _, _, comment in rows if one and comment and not comment.rstrip().endswith(":") and len(left) == 1}
    return sorted(used - valued), sorted(used - told)


def twice_told(text):
    """Symbols that stand for two things on a page of text: with two meanings behind them."""
    meanings = {}
    for left, comment in re.findall(r"^  +([^\n]*?) = [^\n]*?   +(\S[^\n]*)$", text, re.M):
        if not re.search(r"[+²()]| − |^[\d−]", left) and not comment.startswith("at t = ") and not comment.endswith(":"):
            meanings.setdefault(left, set()).add(comment)
    products = {left for left in meanings if " " in left and re.search("[\u0307\u0308]", unicodedata.normalize("NFD", left))}
    return sorted(f"{left}: {' | '.join(sorted(told))}" for left, told in meanings.items()
                  if len(told) > 1 and left not in products and not is_of_matrices(left))


def tree_symbols(tree, into):
    if isinstance(tree, str):
        into.add(tree)
    elif isinstance(tree, list) and tree and isinstance(tree[0], str):
        for part in tree[1:]:
            tree_symbols(part, into)


def json_unexplained(root):
    used, whole = set(), [part for body in root.get("bodies", []) for part in (body["mass"], body["inertia"])]
    whole += [term.get(k) for body in root.get("bodies", []) for term in body["terms"] for k in ("x", "y", "torque")]
    whole += [row[k] for row in root.get("constraints", []) for k in ("g", "multiplier")]
    whole += [each["is"] for each in root["definitions"]]
    for island in root.get("islands", []):
        whole += [entry for k in ("M", "C", "K") for row in island.get(k, []) for entry in row]
        whole += island.get("f", []) + island.get("equations", [])
        whole += [each["is"] for each in island.get("coordinates", [])]
    for tree in whole:
        tree_symbols(tree, used)
    known = {name for name, each in root["symbols"].items() if isinstance(each["value"], (int, float)) and "unit" in each
             and ("property" in each or "quantity" in each)}
    known |= {each["symbol"] for each in root["definitions"] if "unit" in each}
    for island in root.get("islands", []):
        for angle in island.get("angles", []):
            known |= {angle["symbol"], angle["rate"], angle["acceleration"]}
    return sorted(used - known - {"t"})


def check(tinker, scene, form, more):
    name, faults = f"{os.path.basename(scene)} {form} {' '.join(more)}".strip(), []
    for format_, reader in READERS.items():
        text = page(tinker, scene, form, format_, *more)
        without_value, without_words = unexplained(reader(text), form)
        if "=" in text and form == "newton" and not list(reader(text)):
            faults.append(f"{name} {format_}: no equation was found")
        if without_value:
            faults.append(f"{name} {format_}: no value of {', '.join(without_value)}")
        if without_words:
            faults.append(f"{name} {format_}: no meaning of {', '.join(without_words)}")
        if twice := twice_told(text) if format_ == "text" else []:
            faults.append(f"{name}: one symbol for two things, {', '.join(twice)}")
    missing = json_unexplained(json.loads(page(tinker, scene, form, "json", *more)))
    if missing:
        faults.append(f"{name} json: no symbol {', '.join(missing)}")
    return faults


def main():
    tinker, folder = sys.argv[1:]
    scenes = sorted(glob.glob(os.path.join(folder, "*.tinker.json")))
    jobs = [(scene, form, []) for scene in scenes for form in FORMS]
    jobs += [(os.path.join(folder, "friction-incline.tinker.json"), "newton", ["--at", "0.5"])]
    jobs += [(os.path.join(folder, "rolling-race.tinker.json"), "newton", ["--block", "Hoop"])]
    jobs += [(os.path.join(os.path.dirname(__file__), "symbols-that-meet.tinker.json"), form, []) for form in FORMS]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        faults = [fault for found in pool.map(lambda job: check(tinker, *job), jobs) for fault in found]
    print("\n".join(faults + [f"{len(jobs)} pages of {len(scenes)} scenes, {len(faults)} faults"]))
    return 1 if faults or len(scenes) < 40 else 0


if __name__ == "__main__":
    sys.exit(main())
