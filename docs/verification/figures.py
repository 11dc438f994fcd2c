"""Figures of the pages of docs/verification as SVG text, for pages.py."""
import math

ink, soft, grid, frame, allowed = "#1c1e21", "#5b6067", "#e6e9ed", "#c9ced5", "#e8f1f7"
colors = ["#0072b2", "#d55e00", "#00795a"]
font = 'font:13px system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif'


def number(value):
    return f"{value:g}".replace("-", "−")


def document(width, height, title, shapes):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}">\n'
            f"<title>{title}</title>\n<style>text{{{font};fill:{ink}}}text.soft{{fill:{soft}}}</style>\n"
            f'<rect width="{width}" height="{height}" fill="#ffffff"/>\n' + "\n".join(shapes) + "\n</svg>\n")


def text(x, y, words, anchor="start", extra='class="soft"'):
    return f'<text {extra} x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{words}</text>'


def line(x1, y1, x2, y2, color=grid, extra=""):
    return f'<path d="M{x1:.1f} {y1:.1f}L{x2:.1f} {y2:.1f}" stroke="{color}" fill="none" {extra}/>'


class Plot:
    """Frame with linear axes; box = (left, top, width, height) [px], x and y = (from, to)."""

    def __init__(self, box, x, y, x_ticks, y_ticks, title):
        self.left, self.top, self.width, self.height = box
        self.x, self.y = x, y
        bottom = self.top + self.height
        self.shapes = [text(self.left, self.top - 10, title, extra="")]
        for tick in y_ticks:
            self.shapes += [line(self.left, self.at(0, tick)[1], self.left + self.width, self.at(0, tick)[1]),
                            text(self.left - 7, self.at(0, tick)[1] + 4.5, number(tick), "end")]
        self.shapes += [text(self.at(tick, 0)[0], bottom + 18, number(tick), "middle") for tick in x_ticks]
        self.shapes.append(f'<path d="M{self.left} {self.top}V{bottom}H{self.left + self.width}" stroke="{frame}" fill="none"/>')

    def at(self, x, y):
        return (self.left + self.width * (x - self.x[0]) / (self.x[1] - self.x[0]),
                self.top + self.height * (self.y[1] - y) / (self.y[1] - self.y[0]))

    def curve(self, xs, ys, color, dash="none"):
        points = "L".join("{:.1f} {:.1f}".format(*self.at(x, y)) for x, y in zip(xs, ys))
        self.shapes.append(f'<path d="M{points}" stroke="{color}" stroke-width="1.6" stroke-dasharray="{dash}" fill="none"/>')

    def circles(self, xs, ys, color):
        for x, y in zip(xs, ys):
            cx, cy = self.at(x, y)
            self.shapes.append(f'<circle cx="{cx:.1f}" cy="{cy:.1f}" r="5.5" stroke="{color}" stroke-width="1.4" fill="none"/>')

    def bars(self, xs, ys, halves, color):
        """Draws dots with error bars."""
        for x, y, half in zip(xs, ys, halves):
            cx, cy = self.at(x, y)
            self.shapes += [line(cx, self.at(x, y - half)[1], cx, self.at(x, y + half)[1], color, 'stroke-width="1.6"'),
                            f'<circle cx="{cx:.1f}" cy="{cy:.1f}" r="2.2" fill="{color}"/>']


def deviations(claim, tolerance_of):
    """Returns a plot of (number - reference) / accepted difference; None if no number has an accepted difference."""
    rows, ends = [], []
    for case in claim["cases"]:
        ends.append(len(rows))
        for check in case["checks"]:
            if isinstance(check["stemware"], str) or isinstance(check["reference"], str) or not tolerance_of(check):
                continue
            rows.append((check["quantity"], (check["stemware"] - check["reference"]) / tolerance_of(check)))
    if not rows:
        return None
    left, right, top, step = 220, 570, 50, 20
    bottom, x = top + step * len(rows) + 8, lambda value: (left + right) / 2 + value * (right - left) / 2
    shapes = [text(left, top - 28, "(Stemware − reference) / accepted difference", extra=""),
              f'<rect x="{left}" y="{top}" width="{right - left}" height="{bottom - top}" fill="{allowed}"/>']
    shapes += [line(x(tick), top, x(tick), bottom, frame) for tick in (-1, 0, 1)]
    shapes += [text(x(tick), bottom + 18, number(tick), "middle") for tick in (-1, -0.5, 0, 0.5, 1)]
    shapes += [line(left, top + step * (end + 0.2), right, top + step * (end + 0.2), frame) for end in ends if end]
    for i, (name, value) in enumerate(rows):
        y = top + step * (i + 0.7)
        shapes += [text(left - 10, y + 4.5, name, "end"), line(x(0), y, x(value), y, colors[0], 'stroke-width="1.6"'),
                   f'<circle cx="{x(value):.1f}" cy="{y:.1f}" r="4" fill="{colors[0]}"/>']
    return document(right + 30, bottom + 32, claim["title"], shapes)


def harmonics(claim):
    """Returns a plot of the harmonics 2 to 6, one colour per case: reference as circles, Stemware with its band."""
    plot = Plot((60, 50, 400, 250), (1.7, 6.3), (0, 0.005), range(2, 7), [0, 0.001, 0.002, 0.003, 0.004, 0.005],
                "|harmonic| / a₀ over its order n")
    for case, color, name in zip(claim["cases"], colors, ("b/a = 0.5", "0.7", "0.9")):
        orders = [int(check["quantity"][1:]) for check in case["checks"]]
        plot.circles(orders, [abs(check["reference"]) for check in case["checks"]], color)
        plot.bars(orders, [abs(check["stemware"]) for check in case["checks"]], [check["band"] for check in case["checks"]], color)
        plot.shapes.append(text(468, plot.at(6, abs(case["checks"][-1]["reference"]))[1] + 4.5, name, extra=f'style="fill:{color}"'))
    plot.circles([2.0], [0.00465], soft)
    plot.shapes.append(text(98, plot.at(2, 0.00465)[1] + 4.5, "reference"))
    plot.bars([2.0], [0.00425], [1e-4], soft)
    plot.shapes.append(text(98, plot.at(2, 0.00425)[1] + 4.5, "Stemware with its band"))
    return document(550, 332, claim["title"], plot.shapes)
