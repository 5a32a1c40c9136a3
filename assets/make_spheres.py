#!/usr/bin/env python3
"""Writes CornellLeftSphere.obj and CornellRightSphere.obj into this folder; the same bytes every time.

A cube of N x N quads a face, pushed out to a sphere: no poles, quads of similar size, every edge shared by two.
"""

import math
import pathlib

N = 26  # 6 * 26 * 26 quads: 8112 triangles
RADIUS = 90.0
SPHERES = [
    ("CornellLeftSphere", "silver", (420.2, 91.6, 369.5)),
    ("CornellRightSphere", "glass", (130.9, 91.6, 249.6)),
]
HEADER = """\
# {name}: a sphere to stand in CornellBox.obj, {material}.
# Made by make_spheres.py; centre {x} {y} {z}, radius {r:g}. Units of the Cornell box: mm.
# No vn on purpose: smooth normals are made where a file has none.
mtllib {name}.mtl
g {group}
"""


def cube_to_sphere(i, j, k):
    """Lattice point on the cube [0, N]^3 to the unit sphere; tan() keeps the quads of similar size."""
    p = [math.tan(math.pi / 4 * (2 * c / N - 1)) for c in (i, j, k)]
    length = math.sqrt(sum(c * c for c in p))
    return [c / length for c in p]


def quads():
    """Corners on the lattice, counterclockwise seen from outside."""
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, N):
            for a in range(N):
                for b in range(N):
                    ring = [(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)]
                    if side == 0:
                        ring.reverse()
                    corners = []
                    for c, d in ring:
                        point = [0, 0, 0]
                        point[axis], point[u], point[v] = side, c, d
                        corners.append(tuple(point))
                    yield corners


def write_sphere(name, material, centre):
    faces = list(quads())
    index = {}
    for face in faces:
        for corner in face:
            index.setdefault(corner, len(index) + 1)
    x, y, z = centre
    lines = [HEADER.format(name=name, material=material, x=x, y=y, z=z, r=RADIUS, group=material.capitalize() + "Sphere")]
    for corner in index:  # in the order of insertion
        lines.append("v %.4f %.4f %.4f\n" % tuple(c + RADIUS * d for c, d in zip(centre, cube_to_sphere(*corner))))
    lines.append("usemtl %s\n" % material)
    for face in faces:
        lines.append("f %d %d %d %d\n" % tuple(index[corner] for corner in face))
    path = pathlib.Path(__file__).parent / (name + ".obj")
    path.write_text("".join(lines), encoding="ascii", newline="\n")


if __name__ == "__main__":
    for sphere in SPHERES:
        write_sphere(*sphere)
