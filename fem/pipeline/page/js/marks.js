// Marks: curves, points and areas over the axes of a picture. Interface of a mark: { extent(): {x, y}, draw(X, Y, box),
// near(px, py, X, Y): {i, px, py, away}, at(i), rows(), extra }. A row is [name, x, y]; `extra` has further numbers of
// each row: { heading, axis with the unit, values }.
import { s } from './dom.js';

export const clean = list => list.filter(Number.isFinite);
export const place = (x, y) => `${x.toFixed(1)} ${y.toFixed(1)}`;
export const silent = { extent: () => ({ x: [], y: [] }), near: () => null, rows: () => [], count: 0 };

export function nearest(x, y, px, py, X, Y) {
  let found = null;
  x.forEach((value, i) => {
    if (!Number.isFinite(value) || !Number.isFinite(y[i])) return;
    const at = [X(value), Y(y[i])];
    const away = Math.hypot(at[0] - px, at[1] - py);
    if (Number.isFinite(away) && (!found || away < found.away)) found = { i, px: at[0], py: at[1], away };
  });
  return found;
}

function index_near(list, value) {
  let best = -1;
  let least = Infinity;
  list.forEach((x, i) => {
    if (Math.abs(x - value) < least) {
      least = Math.abs(x - value);
      best = i;
    }
  });
  return best;
}

/** Returns a curve with gaps at missing values. `words(i)` replaces the numbers in the label of point i. */
export const line = ({ x, y, name, colour = 'c1', dash, width = 2, words }) => ({
  name,
  colour,
  dash,
  swatch: 'line',
  extent: () => ({ x: clean(x), y: clean(y) }),
  draw: (X, Y) => {
    let pen = false;
    let d = '';
    for (let i = 0; i < x.length; ++i) {
      const there = Number.isFinite(y[i]) && Number.isFinite(x[i]) && (!Y.log || y[i] > 0);
      if (there) d += (pen ? 'L' : 'M') + place(X(x[i]), Y(y[i]));
      pen = there;
    }
    const stroke = { stroke: `var(--${colour})`, 'stroke-width': width, 'stroke-dasharray': dash };
    return s('path', { d, fill: 'none', 'stroke-linejoin': 'round', ...stroke });
  },
  near: (px, py, X, Y) => nearest(x, y, px, py, X, Y),
  value: words ? undefined : at => y[index_near(x, at)], // for labels of points of other curves
  at: i => ({ x: x[i], y: y[i], words: words && words(i) }),
  count: x.length,
  rows: () => x.map((value, i) => [name || '', value, y[i]])
});

const shape_at = (shape, cx, cy, size, paint) =>
  shape === 'square'
    ? s('rect', { x: cx - size, y: cy - size, width: 2 * size, height: 2 * size, ...paint })
    : s('circle', { cx: cx.toFixed(1), cy: cy.toFixed(1), r: size, ...paint });

/** Returns points, optionally with error bars of half-width `band`. */
export const dots = ({ x, y, name, colour = 'c1', size = 4, hollow, band, across, words, shape }) => ({
  name,
  colour,
  swatch: hollow ? 'ring' : size ? shape || 'dot' : 'line',
  extent: () => {
    const ends = (list, other) =>
      band && other ? list.flatMap((v, i) => [v, v + (band[i] || 0), v - (band[i] || 0)]) : list;
    return { x: clean(ends(x, across)), y: clean(ends(y, !across)) };
  },
  draw: (X, Y) =>
    x.map((value, i) => {
      if (!Number.isFinite(y[i]) || !Number.isFinite(value) || (Y.log && !(y[i] > 0)) || (X.log && !(value > 0)))
        return null;
      const [cx, cy] = [X(value), Y(y[i])];
      const half = band && band[i] > 0 ? band[i] : 0;
      const low = Y.log && y[i] - half <= 0 ? Y.range[0] : y[i] - half;
      const bar = across
        ? `M${place(X(value - half), cy)}H${X(value + half).toFixed(1)}`
        : `M${place(cx, Y(low))}V${Y(y[i] + half).toFixed(1)}`;
      const line = `var(--${colour})`;
      const paint = { fill: hollow ? 'var(--card)' : line, stroke: line, 'stroke-width': 1.5 };
      return [
        half ? s('path', { d: bar, stroke: 'var(--ink)', 'stroke-width': 1.5 }) : null,
        size ? shape_at(shape, cx, cy, size, paint) : null
      ];
    }),
  near: (px, py, X, Y) => nearest(x, y, px, py, X, Y),
  at: i => ({ x: x[i], y: y[i], band: band && band[i], words: words && words[i] }),
  count: x.length,
  rows: () => x.map((value, i) => [name || '', value, y[i]]),
  extra: band && [{ heading: '±', axis: across ? 'x' : 'y', values: band }]
});

export const marked = look => [line(look), { ...dots(look), swatch: undefined, rows: () => [] }];

/** Returns bars from `from` to `to` along the numbered rows of a named vertical axis. */
export const bars = ({ from, to, texts, name, colour = 'c1', rows: at, words, pale }) => ({
  name,
  colour,
  swatch: 'bar',
  extent: () => ({ x: clean([...from, ...to]), y: [] }),
  draw: (X, Y) =>
    at.map(
      (row, i) =>
        Number.isFinite(from[i]) &&
        Number.isFinite(to[i]) &&
        s('rect', {
          x: Math.min(X(from[i]), X(to[i])).toFixed(1),
          y: (Y(row) - 0.32 * Y.size).toFixed(1),
          height: (0.64 * Y.size).toFixed(1),
          width: Math.max(1.5, Math.abs(X(to[i]) - X(from[i]))).toFixed(1),
          fill: `var(--${colour})`,
          'fill-opacity': pale ? 0.4 : 1,
          stroke: pale && `var(--${colour})`
        })
    ),
  near: (px, py, X, Y) => {
    const i = at.indexOf(Y.invert(py));
    return i < 0 ? null : { i, px: X(to[i]), py: Y(at[i]), away: 0 };
  },
  at: i => ({ x: to[i], y: at[i], words: words && words[i] }),
  count: at.length,
  rows: () => at.map((row, i) => [name || '', to[i], texts ? texts[i] : row]),
  extra: [{ heading: 'from', axis: 'x', values: from }]
});

/** Returns a horizontal or vertical line across the picture, with a label at its end. */
export const rule = ({ x, y, text, colour = 'soft', dash, low, name }) => ({
  ...silent,
  name,
  colour,
  dash,
  swatch: 'line',
  extent: () => ({ x: clean([x]), y: clean([y]) }),
  draw: (X, Y, box) => {
    const at = x === undefined ? Y(y) : X(x);
    const [first, last] = x === undefined ? [box.top, box.bottom] : [box.left, box.right];
    if (!(at >= first - 1 && at <= last + 1)) return [];
    const d =
      x === undefined ? `M${box.left} ${at.toFixed(1)}H${box.right}` : `M${at.toFixed(1)} ${box.top}V${box.bottom}`;
    const right = x === undefined || at > (box.left + box.right) / 2;
    const [beside, high] = [right ? at - 5 : at + 5, low ? box.bottom - 8 : box.top + 12];
    const place_of_text = x === undefined ? { x: box.right - 4, y: at - 5 } : { x: beside, y: high };
    const spot = { ...place_of_text, 'text-anchor': right ? 'end' : 'start' };
    return [
      s('path', { d, stroke: `var(--${colour})`, 'stroke-dasharray': dash, fill: 'none' }),
      text && s('text', { class: 'soft', ...spot }, text)
    ];
  }
});

export const note = ({ x, y, text, anchor = 'middle', soft = true, dy = 4 }) => ({
  ...silent,
  draw: (X, Y) =>
    s('text', { x: X(x).toFixed(1), y: (Y(y) + dy).toFixed(1), 'text-anchor': anchor, class: soft ? 'soft' : '' }, text)
});
