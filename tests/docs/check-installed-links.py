"""Every relative link of the installed documents leads to an installed file. Installs the build folder into a folder of its own.

Usage: check-installed-links.py MESON BUILD-FOLDER
"""
import pathlib
import re
import subprocess
import sys
import tempfile

LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")


def dead_links(root):
    for document in root.rglob("*.md"):
        for target in LINK.findall(document.read_text(encoding="utf-8")):
            if "://" not in target and not (document.parent / target).exists():
                yield f"{document.relative_to(root)}: {target}"


def main(meson, build_folder):
    with tempfile.TemporaryDirectory() as folder:
        command = [meson, "install", "-C", build_folder, "--no-rebuild", "--quiet", "--destdir", folder]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        root = pathlib.Path(folder)
        documents = len(list(root.rglob("*.md")))
        dead = list(dead_links(root))
    print(f"{documents} documents", *dead, sep="\n")
    return 1 if dead or documents < 20 else 0


sys.exit(main(*sys.argv[1:]))
