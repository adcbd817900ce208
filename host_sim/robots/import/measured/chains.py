"""Kinematic chains of headers that the importer wrote, drawn: a sheet of many, each to its own scale, all seen from the same side.

Of the links of a header: kinds, modified Denavit-Hartenberg parameters, branches, limits, mimics. Every turning joint stands at 0.5 rad, or as
near to it as its limits let it, every slide in the middle of its travel.
"""

import math
import re

TURN, COLUMNS, CELL, ROW = 0.5, 4, 200, 220
AROUND, DOWN = math.radians(-50), math.radians(20)  # where it is seen from
NUMBER = re.compile(r"-?\d[\d.]*(?:e-?\d+)?")


def product(A, B):
    """Of poses, a rotation by rows and a position."""
    (R, p), (S, q) = A, B
    rotation = [[sum(R[i][k] * S[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    return rotation, [p[i] + sum(R[i][k] * q[k] for k in range(3)) for i in range(3)]


def screw(axis, angle, along):
    """A turn about x or z and a shift along it."""
    c, s = math.cos(angle), math.sin(angle)
    rotation = [[1, 0, 0], [0, c, -s], [0, s, c]] if axis == "x" else [[c, -s, 0], [s, c, 0], [0, 0, 1]]
    return rotation, [along, 0, 0] if axis == "x" else [0, 0, along]


def numbers(text):
    return [float(number) for number in NUMBER.findall(text)]


class Link:
    def __init__(self, kind, text, before):
        self.kind, self.text = kind, text
        parent = re.search(r"\.parent\(([^)]*)\)", text)
        self.parent = before if parent is None else -1 if "base" in parent[1] else int(parent[1])
        self.mimics = self.given("mimic")

    def given(self, name):
        found = re.search(rf"\.{name}\(([^)]*)\)", self.text)
        return numbers(found[1]) if found else []

    def length(self, name):
        return (self.given(name) or [0.0])[0]

    def angle(self, name):
        degrees = self.given(f"{name}_deg")
        return math.radians(degrees[0]) if degrees else self.length(name)

    def branch(self):
        degrees = self.given("branch_deg")
        gamma, b = [math.radians(degrees[0]), degrees[1]] if degrees else self.given("branch") or [0.0, 0.0]
        return screw("z", gamma, b)


class Chain:
    def __init__(self, header):
        code = re.sub(r"//.*", "", header)
        found = list(re.finditer(r"axial::(revolute|prismatic)\(\)", code))
        ends = [match.start() for match in found[1:]] + [len(code)]
        self.links = [Link(match[1], code[match.end():end], k - 1) for k, (match, end) in enumerate(zip(found, ends))]
        self.base, self.tool = (self.fixed(code[:found[0].start()], end) for end in ("base", "tool"))

    @staticmethod
    def fixed(code, name):
        found = re.search(rf"axial::{name}\((?:axial::FixedPose)?(.*?)\),\n", code, re.S)
        values = numbers(found[1]) if found else [0.0, 0.0, 0.0]
        if len(values) == 3:
            values = [1, 0, 0, 0, 1, 0, 0, 0, 1, *values]
        return [values[0:3], values[3:6], values[6:9]], values[9:12]

    def position(self, i):
        """Where joint i stands, by the joint that it mimics."""
        link = self.links[i]
        if link.mimics:
            leader, ratio, offset = (*link.mimics, *(1.0, 0.0)[len(link.mimics) - 1:])
            return ratio * self.position(int(leader)) + offset
        low, high = link.given("position_limits") or [-math.inf, math.inf]
        return (low + high) / 2 if link.kind == "prismatic" else min(high, max(low, TURN))

    def poses(self, values=None):
        """Of the frames of all links, and of the tool behind the last one."""
        poses = []
        for i, link in enumerate(self.links):
            value = self.position(i) if values is None else values[i]
            theta, d = link.angle("theta"), link.length("d")
            theta, d = (theta + value, d) if link.kind == "revolute" else (theta, d + value)
            pose = product(self.base if link.parent < 0 else poses[link.parent], link.branch())
            pose = product(pose, screw("x", link.angle("alpha"), link.length("a")))
            poses.append(product(pose, screw("z", theta, d)))
        return poses, product(poses[-1], self.tool)

    def path(self, i, poses):
        """From the parent's origin along its axis, along the common normal, along the joint's own axis."""
        link = self.links[i]
        start = self.base if link.parent < 0 else poses[link.parent]
        branched = product(start, link.branch())
        corner = product(branched, screw("x", 0.0, link.length("a")))
        return [start[1], branched[1], corner[1], poses[i][1]]

    def leaves(self):
        return set(range(len(self.links))) - {link.parent for link in self.links}


def seen(point):
    x, y, z = point
    side, away = y * math.cos(AROUND) - x * math.sin(AROUND), x * math.cos(AROUND) + y * math.sin(AROUND)
    return side, -(z * math.cos(DOWN) - away * math.sin(DOWN))


def scale_bar(reach):
    """The largest 1, 2 or 5 times a power of ten that is at most a third of it."""
    power = 10.0 ** math.floor(math.log10(reach / 3))
    return max(step * power for step in (1, 2, 5) if step * power <= reach / 3 * (1 + 1e-9))


def cell(name, chain):
    poses, tool = chain.poses()
    paths = [chain.path(i, poses) for i in range(len(poses))]
    points = [seen(point) for point in [[0.0, 0.0, 0.0], tool[1], *(point for path in paths for point in path)]]
    low, high = ([pick(point[k] for point in points) for k in (0, 1)] for pick in (min, max))
    reach = max(high[0] - low[0], high[1] - low[1])
    scale, middle = 120.0 / reach, [(low[k] + high[k]) / 2 for k in (0, 1)]

    def at(point):
        u, v = seen(point)
        return f"{CELL / 2 + scale * (u - middle[0]):.1f},{105 + scale * (v - middle[1]):.1f}"

    def line(kind, *ends):
        return f'<polyline class="{kind}" points="{" ".join(at(end) for end in ends)}"/>'

    def along(pose, axis, length):
        return [pose[1][i] + length / scale * pose[0][i][axis] for i in range(3)]

    bar = scale_bar(reach)
    said = f"{bar:g} m" if bar >= 0.1 else f"{bar * 1000:g} mm"
    drawn = [f'<text x="{CELL / 2:g}" y="18" class="name">{name}</text>',
             f'<polyline class="bar" points="15,206 {15 + scale * bar:.1f},206"/><text x="{20 + scale * bar:.1f}" y="210">{said}</text>',
             line("link", [0.0, 0.0, 0.0], chain.base[1]), *(line("link", *path) for path in paths)]
    drawn += [line("link", poses[-1][1], tool[1])] if len(chain.leaves()) == 1 else []
    for link, pose in zip(chain.links, poses):
        drawn.append(line(link.kind, along(pose, 2, -7), along(pose, 2, 7)))
    if len(chain.leaves()) == 1:
        drawn += [line(f"axis {name}", tool[1], along(tool, k, 16)) for k, name in enumerate("xyz")]
    return drawn + [line("ground", [-9 / scale, 0.0, 0.0], [9 / scale, 0.0, 0.0]), line("ground", [0.0, -9 / scale, 0.0], [0.0, 9 / scale, 0.0])]


STYLE = """text{font:11px sans-serif;fill:#333}.name{font:bold 13px sans-serif;text-anchor:middle}polyline{fill:none;stroke-linejoin:round}
.link{stroke:#777;stroke-width:3}.revolute{stroke:#1f6fb4;stroke-width:7;stroke-linecap:round}.prismatic{stroke:#d9722a;stroke-width:7;stroke-linecap:square}
.ground,.bar{stroke:#333;stroke-width:2}.axis{stroke-width:2}.x{stroke:#c0392b}.y{stroke:#2e8b57}.z{stroke:#2c3e90}"""


def sheet(named):
    """SVG of chains by their names."""
    rows = -(-len(named) // COLUMNS)
    width, height = COLUMNS * CELL, rows * ROW
    text = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}">\n<style>{STYLE}</style>\n'
    text += f'<rect width="{width}" height="{height}" fill="#fff"/>\n'
    for k, (name, chain) in enumerate(named.items()):
        text += f'<g transform="translate({k % COLUMNS * CELL},{k // COLUMNS * ROW})">\n' + "\n".join(cell(name, chain)) + "\n</g>\n"
    return text + "</svg>\n"
