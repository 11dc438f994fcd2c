// Pictures of a sweep over one or two entries: curves, or maps over two numerical entries.
import { dots, line, marked } from '../js/marks.js';
import { grid, patches } from '../js/shapes.js';
import { label_of, shown } from '../js/words.js';
import { one_way } from './spin.js';

const colours = ['c1', 'c2', 'c3', 'c4', 'c5', 'c6', 'ink', 'c8'];
const dashes = [undefined, '8 4', '9 3 2 3', '3 3', '12 3', '9 3 2 3 2 3', '6 3', '2 2'];

/**
 * Returns true if a curve jumps between the values i and i + 1. No line is drawn over a jump. In the one or two
 * intervals of a jump, the value changes more than four times as much as in the intervals to the left and to the right.
 * A jump has two intervals if the spin changes its sense and is zero at a value in between.
 */
function jumps(y, i) {
  const step = j => (y[j] === null || y[j + 1] === null ? NaN : Math.abs(y[j + 1] - y[j]));
  const jumps_over = (first, n) => {
    if (first <= 0 || first + n + 1 >= y.length) return false;
    const beside = Math.max(step(first - 1), step(first + n));
    const least = Math.min(step(first), step(first + n - 1));
    return least > 4 * beside && beside > 1e-9 * least; // no jump between values that are constant except for rounding
  };
  return jumps_over(i, 1) || jumps_over(i, 2) || jumps_over(i - 1, 2);
}

function broken(x, y) {
  const places = x.flatMap((at, i) => {
    const here = [at, y[i] ?? NaN];
    return jumps(y, i) ? [here, [(at + x[i + 1]) / 2, NaN]] : [here];
  });
  return { x: places.map(p => p[0]), y: places.map(p => p[1]) };
}

function curves(axis, y, list) {
  return {
    x: axis,
    y: { ...y, digits: '.5g' },
    marks: list.flatMap(({ name, values }, i) => {
      const look = { ...broken(axis.values, values), name, colour: colours[i % 8], dash: dashes[i % 8], size: 3 };
      return look.x.length > 40 ? [line(look)] : marked(look);
    })
  };
}

/** Returns the edges of the cells around values: the mean of neighbouring values, geometric on a logarithmic axis. */
function edges_of({ values, log }) {
  const middle = (a, b) => (log ? Math.sqrt(a * b) : (a + b) / 2);
  const beyond = (a, b) => (log ? (a * a) / b : 2 * a - b);
  const inner = values.slice(1).map((v, i) => middle(v, values[i]));
  return [beyond(values[0], inner[0]), ...inner, beyond(values[values.length - 1], inner[inner.length - 1])];
}

function map([x, y], shows, values) {
  const rows = y.values.map((_, j) => x.values.map((_, i) => values[i * y.values.length + j]));
  const known = values.filter(Number.isFinite);
  let [low, high] = [Math.min(...known), Math.max(...known)];
  const both_signs = low < 0 && high > 0;
  if (both_signs) [low, high] = [-Math.max(-low, high), Math.max(-low, high)];
  const edges = [edges_of(x), edges_of(y)];
  const range = k => [edges[k][0], edges[k][edges[k].length - 1]].sort((a, b) => a - b);
  const scale = { range: [low, high], label: label_of(shows), both_signs };
  const say = ({ label, unit }, v) => `${label} ${shown(v, '.5g')} ${unit === '1' ? '' : unit}`.trim();
  const words = k => {
    const [i, j] = [k % x.values.length, Math.floor(k / x.values.length)];
    return [say(x, x.values[i]), say(y, y.values[j]), say(shows, rows[j][i])];
  };
  const places = x.values.flatMap((at, i) => y.values.map((up, j) => [at, up, rows[j][i]])).filter(([, , v]) => !Number.isFinite(v));
  const empty = { x: places.map(p => p[0]), y: places.map(p => p[1]) };
  return {
    x: { ...x, range: range(0) },
    y: { ...y, range: range(1) },
    height: 340,
    always_named: places.length > 0,
    colours: scale,
    marks: [patches({ ...grid(...edges, rows), colours: scale, words }), dots({ ...empty, name: places.length ? 'no value: tips, undefined or failed' : '', colour: 'ink', size: 3 })]
  };
}

const titles = {
  omega_terminal: 'Terminal spin',
  harmonic_effect: 'Effect of the higher harmonics of the load on the terminal spin',
  contact_fraction: 'Share of the land’s area under pressure at rest',
  tau_at_rest: 'Torque of friction at rest'
};
const max_curves = 7;
const min_of_map = 4;

/** Returns the pictures of the grid of a document; none for texts and for constant quantities. */
export function grid_pictures(doc) {
  const { tables } = doc;
  if (!tables.grid) return [];
  const { quantities } = tables.grid;
  const entries = tables.grid.entries.map(entry => ({
    ...entry,
    is_numeric: entry.unit !== '' && entry.values.length > 1,
    names: entry.values.map(value => (Number.isNaN(Number(value)) ? value.slice(-30) : shown(Number(value), '.3g'))),
    values: entry.values.map(Number)
  }));
  const [first, second] = entries;
  const all_numbers = second && first.is_numeric && second.is_numeric;
  const [n, m] = [first.values.length, second?.values.length];
  const by_second = second && (!first.is_numeric || (all_numbers && n <= max_curves && n < m));
  const [axis, other] = by_second ? [second, first] : [first, second];
  if (!axis.is_numeric) return [];
  const is_map = all_numbers && Math.min(n, m) >= min_of_map;
  const along = values => // one list for each value of the other entry with a solved case
    other.names
      .map((name, c) => ({ name, values: axis.values.map((_, i) => values[by_second ? c * m + i : i * m + c]) }))
      .filter(curve => curve.values.some(Number.isFinite));
  const falls = quantities.omega_fall.values.some(Number.isFinite);
  const notes = (falls ? ' In cases without a terminal spin the glass tips over while it spins up.' : '') + one_way(doc);
  const of = key => quantities[key].values;
  const drawn = key => {
    if (is_map) return map(entries, quantities[key], of(key));
    if (other) return curves(axis, quantities[key], along(of(key)));
    const compared = [
      { name: 'all harmonics', values: of(key) },
      { name: 'first harmonic only', values: of('omega_first_harmonic') },
      { name: 'first harmonic on a ring', values: of('omega_on_ring') }
    ];
    return curves(axis, quantities[key], key === 'omega_terminal' ? compared : [{ name: '', values: of(key) }]);
  };
  return Object.keys(titles).flatMap(key => {
    const known = of(key).filter(Number.isFinite);
    const [low, high] = [Math.min(...known), Math.max(...known)];
    if (!(high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high)))) return [];
    const by = other && !is_map ? `By ${label_of(other)}.` : '';
    const alone =
      'Of all harmonics of the load, the first harmonic only, and a first harmonic on a ring of the contact radius. No line ' +
      'is drawn over a jump.';
    return {
      id: key,
      title: titles[key],
      words: `${known.length} cases`,
      caption: (!other && key === 'omega_terminal' ? alone : by) + notes,
      ...drawn(key)
    };
  });
}
