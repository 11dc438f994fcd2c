// Marks with an area or a direction: coloured patches, contour lines, arrows, outlines.
import { s } from './dom.js';
import { clean, line, nearest, place, silent } from './marks.js';

const dark_to_light = [
  [0, 32, 77],
  [49, 68, 107],
  [102, 105, 112],
  [149, 143, 120],
  [203, 186, 105],
  [255, 234, 70]
];
const blue_white_red = [
  [33, 102, 172],
  [247, 247, 247],
  [178, 24, 43]
];
/** Returns the colour at `t` from 0 to 1. The lightness has uniform steps; in a signed scale, zero is white. */
export function colour_at(t, both_signs) {
  const stops = both_signs ? blue_white_red : dark_to_light;
  const at = Math.max(0, Math.min(0.9999, t)) * (stops.length - 1);
  const i = Math.floor(at);
  return `rgb(${stops[i].map((c, k) => Math.round(c + (at - i) * (stops[i + 1][k] - c))).join(',')})`;
}

function contains(polygon, x, y) {
  let inside = false;
  polygon.forEach(([x1, y1], k) => {
    const [x0, y0] = polygon[(k || polygon.length) - 1];
    if (y0 > y !== y1 > y && x < x0 + ((y - y0) / (y1 - y0)) * (x1 - x0)) inside = !inside;
  });
  return inside;
}

/** Returns coloured polygons [[x, y], ...], each with one value. `words(i)`: label of polygon i. */
export const patches = ({ polygons, value, colours: { range, both_signs, label }, words, name, lines }) => {
  const levels = 48;
  const share = v => (v - range[0]) / (range[1] - range[0] || 1);
  const level = v => Math.max(0, Math.min(levels - 1, Math.floor(share(v) * levels)));
  const middle = (polygon, k) => polygon.reduce((sum, p) => sum + p[k], 0) / polygon.length;
  return {
    ...silent,
    name,
    extent: () => ({
      x: clean(polygons.flatMap(p => p.map(q => q[0]))),
      y: clean(polygons.flatMap(p => p.map(q => q[1])))
    }),
    draw: (X, Y) => {
      const paths = Array(levels).fill('');
      polygons.forEach((polygon, i) => {
        if (Number.isFinite(value[i]))
          paths[level(value[i])] += polygon.map(([x, y], k) => (k ? 'L' : 'M') + place(X(x), Y(y))).join('') + 'Z';
      });
      return paths.map((d, k) => {
        const colour = colour_at((k + 0.5) / levels, both_signs);
        const stroke = { stroke: lines ? 'var(--c8)' : colour, 'stroke-width': lines ? 0.3 : 0.6 };
        return d && s('path', { d, fill: colour, ...stroke });
      });
    },
    near: (px, py, X, Y) => {
      const i = polygons.findIndex(polygon => contains(polygon, X.invert(px), Y.invert(py)));
      return i < 0 || !Number.isFinite(value[i]) ? null : { i, px, py, away: 0 };
    },
    at: i => ({ words: words(i) }),
    rows: () => polygons.map(polygon => [name || '', middle(polygon, 0), middle(polygon, 1)]),
    extra: [{ heading: label, values: value }]
  };
};

/** Returns polygons and values of a grid whose cells lie between the edges x[i], x[i + 1] and y[j], y[j + 1]; value[j][i]. */
export const grid = (x, y, value) => ({
  value: value.flat().map(v => v ?? NaN),
  polygons: value.flatMap((list, j) =>
    list.map((_, i) => [
      [x[i], y[j]],
      [x[i + 1], y[j]],
      [x[i + 1], y[j + 1]],
      [x[i], y[j + 1]]
    ])
  )
});

export function arrow(x0, y0, x1, y1, head = 6) {
  const n = Math.hypot(x1 - x0, y1 - y0);
  if (n < 1) return '';
  const [a, b, w] = [(x1 - x0) / n, (y1 - y0) / n, Math.min(head, n / 2)];
  const left = place(x1 - w * a + 0.5 * w * b, y1 - w * b - 0.5 * w * a);
  const right = place(x1 - w * a - 0.5 * w * b, y1 - w * b + 0.5 * w * a);
  return `M${place(x0, y0)}L${place(x1, y1)}M${left}L${place(x1, y1)}L${right}`;
}

export const arrows = ({ x, y, u, v, name, colour = 'c1', words, width = 1.6, head = 6 }) => ({
  ...silent,
  name,
  colour,
  swatch: 'line',
  extent: () => ({ x: clean([...x, ...x.map((p, i) => p + u[i])]), y: clean([...y, ...y.map((p, i) => p + v[i])]) }),
  draw: (X, Y) =>
    s('path', {
      fill: 'none',
      stroke: `var(--${colour})`,
      'stroke-width': width,
      'stroke-linejoin': 'round',
      d: x.map((_, i) => arrow(X(x[i]), Y(y[i]), X(x[i] + u[i]), Y(y[i] + v[i]), head)).join('')
    }),
  near: (px, py, X, Y) => {
    const middle = (list, by) => list.map((p, i) => p + by[i] / 2);
    return words ? nearest(middle(x, u), middle(y, v), px, py, X, Y) : null;
  },
  at: i => ({ x: x[i] + u[i] / 2, y: y[i] + v[i] / 2, words: words && words[i] }),
  count: words ? x.length : 0,
  rows: () => x.map((_, i) => [name || '', x[i], y[i]]),
  extra: [
    { heading: 'Δx', axis: 'x', values: u },
    { heading: 'Δy', axis: 'y', values: v }
  ]
});

/** Returns the straight lines of a drawing: [[x0, y0, x1, y1], ...] in the units of the axes; `heads`: 1 or 2 arrows. */
export const strokes = ({ lines, colour = 'soft', width = 1, dash, heads = 0 }) => ({
  ...silent,
  extent: () => ({ x: lines.flatMap(l => [l[0], l[2]]), y: lines.flatMap(l => [l[1], l[3]]) }),
  draw: (X, Y) =>
    s('path', {
      fill: 'none',
      stroke: `var(--${colour})`,
      'stroke-width': width,
      'stroke-dasharray': dash,
      d: lines
        .map(([x0, y0, x1, y1]) => {
          const [a, b, c, d] = [X(x0), Y(y0), X(x1), Y(y1)];
          if (!heads) return `M${place(a, b)}L${place(c, d)}`;
          return arrow(a, b, c, d) + (heads > 1 ? arrow(c, d, a, b) : '');
        })
        .join('')
    })
});

export const outline = ({ x, y, name, colour = 'ink', fill = 'none', width = 1.5, opacity = 1 }) => ({
  ...line({ x: [...x, x[0]], y: [...y, y[0]], name, colour, width }),
  near: () => null,
  count: 0,
  rows: () => [],
  draw: (X, Y) =>
    s('path', {
      d: x.map((v, i) => (i ? 'L' : 'M') + place(X(v), Y(y[i]))).join('') + 'Z',
      fill: fill === 'none' ? 'none' : `var(--${fill})`,
      'fill-opacity': opacity,
      stroke: `var(--${colour})`,
      'stroke-width': width
    })
});
