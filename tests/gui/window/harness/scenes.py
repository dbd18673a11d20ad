"""Scene files for tests, as plain data."""
import json


def mass(name, x, y, **more):
    return {"type": "mass", "name": name, "position": [x, y], "width": 0.8, "height": 0.8, **more}


def support(name, x, y, **more):
    return {"type": "support", "name": name, "position": [x, y], **more}


def connector(kind, name, *ends, **more):
    """Ends are names of blocks, or (x, y) where they are detached."""
    return {"type": kind, "name": name, "ends": [end if isinstance(end, (str, dict)) else list(end) for end in ends],
            **more}


def spring(name, *ends, **more):
    return connector("spring", name, *ends, **more)


def scene(*blocks, width=10, grid=0.2, duration=10, **more):
    return {"tinker": 1, "canvas": {"width": width, "grid": grid, "snap": True},
            "run": {"duration": duration, "interval": 0.01}, "blocks": list(blocks), **more}


def write(folder, name, content):
    file = folder / name
    file.write_text(json.dumps(content))
    return file
