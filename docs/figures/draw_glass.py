#!/usr/bin/env python3
"""Draws docs/figures/glass.svg: the spinning wine glass from behind and from above, with the names of its quantities.

    python3 docs/figures/draw_glass.py

Conventions as everywhere in Stemware: x along the direction of travel, y to the orbit's centre, z up, theta from the
direction of travel, counter-clockwise seen from above. Moment ratio and crest of the load belong to the default
study before the glass spins.
"""

import math
import pathlib

WIDTH, HEIGHT = 830, 430
INK, SOFT, GLASS = "#1c1e21", "#5b6067", "#e8f1f7"
PRESSURE, FORCE, MOTION, SPIN = "#0072b2", "#d55e00", "#00795a", "#a3467f"
MOMENT_RATIO, CREST = 0.66, math.radians(-24.8)

shapes = []


def load(theta):
    """Load over its mean, a first harmonic."""
    return 1 + MOMENT_RATIO * math.cos(theta - CREST)


def line(x1, y1, x2, y2, color=INK, width=1.2, extra=""):
    shapes.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{color}" '
                  f'stroke-width="{width}" {extra}/>')


def path(commands, color=INK, width=1.4, fill="none", extra=""):
    shapes.append(f'<path d="{commands}" stroke="{color}" stroke-width="{width}" fill="{fill}" {extra}/>')


def circle(x, y, radius, color=INK, width=1.4, fill="none", extra=""):
    shapes.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius:.1f}" stroke="{color}" stroke-width="{width}" '
                  f'fill="{fill}" {extra}/>')


def text(x, y, words, color=INK, anchor="start", size=15, style=""):
    shapes.append(f'<text x="{x:.1f}" y="{y:.1f}" fill="{color}" text-anchor="{anchor}" font-size="{size}" {style}>'
                  f'{words}</text>')


def symbol(letter, index=""):
    """A formula's letter with its index."""
    below = f'<tspan dy="4" font-size="11">{index}</tspan><tspan dy="-4">&#8203;</tspan>' if index else ""
    return f'<tspan font-style="italic">{letter}</tspan>{below}'


def head(x, y, direction, color, size=9):
    """Point of an arrow at (x, y); direction in radians on the page, 0 to the right, pi/2 down."""
    corners = [(x, y)] + [(x - size * math.cos(direction + turn), y - size * math.sin(direction + turn))
                          for turn in (0.38, -0.38)]
    path("M" + " L".join(f"{cx:.1f},{cy:.1f}" for cx, cy in corners) + " Z", color, 0.5, color)


def arrow(x1, y1, x2, y2, color=INK, width=2.0, size=9):
    direction = math.atan2(y2 - y1, x2 - x1)
    line(x1, y1, x2 - 0.7 * size * math.cos(direction), y2 - 0.7 * size * math.sin(direction), color, width)
    head(x2, y2, direction, color, size)


def dimension(x1, y1, x2, y2):
    """A line with a point at both ends."""
    direction = math.atan2(y2 - y1, x2 - x1)
    line(x1, y1, x2, y2, SOFT, 1)
    head(x2, y2, direction, SOFT, 7)
    head(x1, y1, direction + math.pi, SOFT, 7)


def smooth(points):
    """A curve through the points (Catmull-Rom)."""
    commands = f"M{points[0][0]:.1f},{points[0][1]:.1f}"
    for i in range(len(points) - 1):
        before, here, there, after = (points[max(i - 1, 0)], points[i], points[i + 1],
                                      points[min(i + 2, len(points) - 1)])
        first = [here[k] + (there[k] - before[k]) / 6 for k in (0, 1)]
        second = [there[k] - (after[k] - here[k]) / 6 for k in (0, 1)]
        commands += (f" C{first[0]:.1f},{first[1]:.1f} {second[0]:.1f},{second[1]:.1f} "
                     f"{there[0]:.1f},{there[1]:.1f}")
    return commands


def from_behind():
    """The glass seen along its direction of travel: y to the left, z up. 1.45 points are a millimetre."""
    scale, axis, table = 1.45, 190, 340
    at = lambda y, z: (axis - scale * y, table - scale * z)  # noqa: E731
    text(axis, 26, "from behind", SOFT, "middle", 14)

    half = [(27, 0.9), (30, 0), (33, 0.9), (36, 3), (33, 4.8), (20, 7.5), (9, 13), (5, 22), (4, 36), (4, 82), (7, 92),
            (20, 102), (32, 116), (38, 136), (37.5, 160), (33, 196)]
    right = smooth([at(-r, z) for r, z in half])
    left = smooth([at(r, z) for r, z in reversed(half)])
    left = "L" + left[1:]
    path(right + " " + left + " Z", INK, 1.6, GLASS)
    line(*at(0, 206), *at(0, -6), SOFT, 0.9, 'stroke-dasharray="7 3 1.5 3"')
    line(40, table + 1, 330, table + 1, INK, 1.6)
    text(330, table + 18, "table", SOFT, "end", 14)

    # The hand holds the stem below the centre of mass.
    hand_x, hand_y = at(0, 30)
    shapes.append(f'<rect x="{hand_x - 70:.1f}" y="{hand_y - 11:.1f}" width="78" height="13" rx="6.5" '
                  f'fill="#f6dcc8" stroke="{INK}" stroke-width="1.2"/>')
    shapes.append(f'<rect x="{hand_x - 70:.1f}" y="{hand_y - 1:.1f}" width="64" height="13" rx="6.5" '
                  f'fill="#f6dcc8" stroke="{INK}" stroke-width="1.2"/>')
    arrow(hand_x - 74, hand_y, hand_x - 122, hand_y, FORCE, 2.6, 11)
    text(hand_x - 124, hand_y - 14, "hand pulls", FORCE, "start", 15)
    text(hand_x - 160, hand_y + 20, "towards the", SOFT, "start", 13)
    text(hand_x - 160, hand_y + 35, "orbit’s centre", SOFT, "start", 13)

    # Centre of mass, its height, and the height of the hand below it.
    x, y = at(0, 80)
    circle(x, y, 5.5, INK, 1.4, "#ffffff")
    path(f"M{x:.1f},{y:.1f} v-5.5 a5.5,5.5 0 0 1 5.5,5.5 Z M{x:.1f},{y:.1f} v5.5 a5.5,5.5 0 0 1 -5.5,-5.5 Z", INK, 0.3, INK)
    text(x - 12, y + 5, "centre of mass", INK, "end", 14)
    for height, length in ((80, 112), (30, 72)):
        line(axis + 12, at(0, height)[1], axis + length, at(0, height)[1], SOFT, 0.8, 'stroke-dasharray="2 3"')
    dimension(axis + 64, at(0, 80)[1], axis + 64, at(0, 30)[1])
    text(axis + 70, at(0, 53)[1], "|Δ" + symbol("z") + "|", INK)
    dimension(axis + 105, at(0, 80)[1], axis + 105, table)
    text(axis + 111, at(0, 42)[1], symbol("z", "CM"), INK)

    # Pressure on both sides of the rim, its radius.
    for side in (1, -1):
        x = at(30 * side, 0)[0]
        size = 34 * load(side * math.pi / 2)
        arrow(x, table + 4 + size, x, table + 4, PRESSURE, 4.5, 12)
    text(axis + 62, table + 46, "presses harder on the outside", PRESSURE, "start", 14)
    dimension(axis, table + 64, at(-30, 0)[0], table + 64)
    line(axis, table + 8, axis, table + 70, SOFT, 0.8, 'stroke-dasharray="2 3"')
    text(axis + 16, table + 82, symbol("R"), INK)


def from_above():
    """The glass on its orbit: x up, y to the left. Not to scale."""
    centre_x, y0, orbit, radius = 425, 235, 190, 54
    x0 = centre_x + orbit
    text(x0 - 30, 26, "from above", SOFT, "middle", 14)
    on_page = lambda theta, r: (x0 - r * math.sin(theta), y0 - r * math.cos(theta))  # noqa: E731

    start, end = math.radians(28), math.radians(-56)
    path(f"M{centre_x + orbit * math.cos(start):.1f},{y0 + orbit * math.sin(start):.1f} A{orbit},{orbit} 0 0 0 "
         f"{centre_x + orbit * math.cos(end):.1f},{y0 + orbit * math.sin(end):.1f}", MOTION, 1.4,
         extra='stroke-dasharray="7 5"')
    head(centre_x + orbit * math.cos(end), y0 + orbit * math.sin(end), end - math.pi / 2, MOTION, 11)
    text(centre_x + orbit * math.cos(end) - 14, y0 + orbit * math.sin(end) + 8, "orbit", MOTION, "end")
    circle(centre_x, y0, 3.5, INK, 1, INK)
    text(centre_x - 8, y0 + 24, "orbit’s centre", INK, "start", 14)
    line(centre_x, y0, x0, y0, SOFT, 1)
    text(centre_x + 62, y0 - 8, symbol("ρ"), INK)

    # The rim, and outside of it how hard the table presses.
    angles = [math.radians(i) for i in range(0, 360, 3)]
    band = [on_page(a, radius + 17 * load(a)) for a in angles]
    path("M" + " L".join(f"{x:.1f},{y:.1f}" for x, y in band) + " Z", PRESSURE, 1.2, PRESSURE, 'fill-opacity="0.28"')
    circle(x0, y0, radius, INK, 1.8, GLASS)
    line(x0, y0, centre_x + orbit - radius - 20, y0, SOFT, 1)
    for i in range(8):
        theta = math.radians(45 * i)
        x, y = on_page(theta, radius)
        arrow(x, y, x, y + 25 * load(theta), INK, 1.8, 8)
    arrow(x0, y0, x0, y0 - 118, MOTION, 2.6, 11)
    text(x0 - 10, y0 - 108, symbol("v"), MOTION, "end", 17)
    circle(x0, y0, 2.5, INK, 1, INK)
    x, y = on_page(CREST, radius + 17 * load(CREST) + 6)
    text(x + 8, y + 2, "pressure " + symbol("λ") + "(" + symbol("θ") + ")", PRESSURE, "start", 14)

    # Clockwise on the page is clockwise from above.
    reach, first, last = 112, math.radians(62), math.radians(150)
    x1, y1 = x0 + reach * math.cos(first), y0 + reach * math.sin(first)
    x2, y2 = x0 + reach * math.cos(last), y0 + reach * math.sin(last)
    path(f"M{x1:.1f},{y1:.1f} A{reach},{reach} 0 0 1 {x2:.1f},{y2:.1f}", SPIN, 2.8)
    head(x2 + 1, y2 - 4, last + math.pi / 2, SPIN, 13)
    text(x0 - 36, y0 + reach + 26, "spin " + symbol("ω") + ": against the orbit", SPIN, "middle", 15)
    text(x0 + 72, y0 + 64, "friction, stronger", INK, "start", 14)
    text(x0 + 72, y0 + 82, "on the outside", INK, "start", 14)


def main():
    from_behind()
    from_above()
    title = ("A wine glass seen from behind and from above. The hand pulls towards the orbit's centre, below the centre "
             "of mass; the rim presses harder on the outside; friction is stronger there and turns the glass against "
             "its orbit.")
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" '
           f'height="{HEIGHT}" font-family="sans-serif" role="img" aria-label="{title}">\n'
           f'<title>{title}</title>\n<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>\n'
           + "\n".join(shapes) + "\n</svg>\n")
    pathlib.Path(__file__).with_name("glass.svg").write_text(svg, encoding="utf-8")


if __name__ == "__main__":
    main()
