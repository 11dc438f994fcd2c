// Scales of a picture: linear, logarithmic, or named rows.
import { shown } from './words.js';
import { width_of } from './dom.js';

/** Returns about n round numbers, at least two, between `low` and `high`, and their format. */
function ticks_of(low, high, n) {
  const raw = (high - low) / n;
  const power = 10 ** Math.floor(Math.log10(raw));
  const steps = [0.1, 0.2, 0.5, 1, 2, 5, 10].map(x => x * power);
  const has_two = x => Math.floor(high / x + 1e-9) > Math.ceil(low / x - 1e-9);
  let k = steps.findIndex((x, i) => i > 2 && x >= raw * (1 - 1e-9));
  while (k > 0 && !has_two(steps[k])) --k;
  const step = steps[k];
  const list = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) list.push(i * step);
  const digits = step >= 1 || step < 1e-4 ? '.9g' : `.${Math.ceil(-Math.log10(step) - 1e-9)}f`;
  return { list, text: x => shown(Number(x.toPrecision(12)), digits) };
}

function log_ticks_of(low, high, n) {
  const first = Math.floor(Math.log10(low));
  const last = Math.ceil(Math.log10(high));
  const is_inside = x => x >= low * (1 - 1e-9) && x <= high * (1 + 1e-9);
  const powers = (every, digits) => {
    const list = [];
    for (let p = first; p <= last; ++p)
      for (const digit of (p - last) % every ? [] : digits) list.push(digit * 10 ** p);
    return list.filter(is_inside);
  };
  const few = powers(Math.ceil((last - first) / n), [1]);
  const more = [[1], [1, 2, 5], [1, 2, 3, 4, 5, 6, 7, 8, 9]].map(digits => powers(1, digits));
  const inside = (last - first > 2 ? [few, ...more] : more.slice(1)).find(list => list.length > 1) || more[2];
  return { list: inside, text: x => shown(x, high < 1e5 && low >= 1e-3 ? '.3g' : '.0e') };
}

function range_of(axis, found) {
  const values = found.filter(x => Number.isFinite(x) && (!axis.log || x > 0));
  if (!values.length) return axis.log ? [0.1, 10] : [0, 1];
  let low = values.reduce((a, b) => Math.min(a, b));
  let high = values.reduce((a, b) => Math.max(a, b));
  if (axis.zero) [low, high] = [Math.min(low, 0), Math.max(high, 0)];
  if (axis.log) {
    const room = (high / low) ** 0.04;
    return low === high ? [low / 3, high * 3] : [low / room, high * room];
  }
  const room = (axis.room ?? 0.05) * (high - low) || (high === low ? Math.abs(high) * 0.1 || 1 : 0);
  const ends_at_zero = end => axis.zero && end === 0 && low < high;
  return [low - (ends_at_zero(low) ? 0 : room), high + (ends_at_zero(high) ? 0 : room)];
}

function rows_scale(rows, from, to) {
  const size = (to - from) / rows.length;
  return Object.assign(i => from + size * (i + 0.5), {
    invert: place => Math.floor((place - from) / size),
    size: Math.abs(size),
    range: [0, rows.length],
    ticks: { list: rows.map((_, i) => i), text: i => rows[i] }
  });
}

/**
 * Returns the scale of `axis` { label, range, log, rows, ticks, room, zero, close } for the values `found` of the
 * marks: a function from values to positions between `from` and `to` on the page, with its inverse `.invert` and its
 * `.ticks`.
 */
export function scale(axis, found, from, to) {
  if (axis.rows) return rows_scale(axis.rows, from, to);
  const [low, high] = axis.range || range_of(axis, found);
  const f = axis.log ? Math.log10 : x => x;
  const inverse = axis.log ? x => 10 ** x : x => x;
  const a = f(low);
  const slope = (to - from) / (f(high) - a);
  const n = Math.max(axis.log ? 3 : 2, Math.abs(to - from) / (axis.close || 46));
  const given = axis.ticks && { list: axis.ticks.filter(x => x >= low && x <= high), text: x => shown(x) };
  return Object.assign(x => from + slope * (f(x) - a), {
    invert: place => inverse(a + (place - from) / slope),
    range: [low, high],
    ticks: given || (axis.log ? log_ticks_of : ticks_of)(low, high, n),
    log: axis.log
  });
}

/** Returns two scales with the same length per unit in both directions. */
export function same_step(X, Y, box) {
  const [width, height] = [box.right - box.left, box.bottom - box.top];
  const step = Math.max((X.range[1] - X.range[0]) / width, (Y.range[1] - Y.range[0]) / height);
  const around = ({ range: [low, high] }, length) => [-1, 1].map(side => (low + high) / 2 + (side * step * length) / 2);
  return [
    scale({ range: around(X, width) }, [], box.left, box.right),
    scale({ range: around(Y, height) }, [], box.bottom, box.top)
  ];
}

export const widest = scale => Math.max(0, ...scale.ticks.list.map(x => width_of(scale.ticks.text(x))));
