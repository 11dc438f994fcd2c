// Pictures of a live answer, as data for the figures that reports have too.
import { all_harmonics, band, digits, found, pair, say, state, words } from './state.js';
import { bars, dots, line } from '../js/marks.js';
import { grid, patches } from '../js/shapes.js';
import { shown } from '../js/words.js';

const numbers = list => (list || []).map(v => v ?? NaN);
const radians = degrees => (degrees * Math.PI) / 180;
const signed_degrees = angle => (((angle * 180) / Math.PI + 540) % 360) - 180;
export const end_of = row => row && (row.at_end || row.at_rest);

/** The load at an azimuth of a state, up to harmonic n. */
export function load_at({ a, b }, theta, n = Infinity) {
  let sum = 0;
  for (let k = 0; k < a.length && k <= n; ++k) sum += a[k] * Math.cos(k * theta) + b[k] * Math.sin(k * theta);
  return sum;
}

/** Names, colours and dashes of the three models. */
const looks = () => ({
  all: { name: words().all, colour: 'c1' },
  first: { name: say(words().first, state.harmonics), colour: 'c2' },
  paper: { name: words().paper, colour: 'c8', dash: '5 4' }
});
const around = () => ({
  label: words().theta,
  symbol: 'θ =',
  digits: '.4g',
  range: [-180, 180],
  ticks: [-180, -90, 0, 90, 180]
});

function load() {
  const { answer } = found;
  const state_of_all = end_of(answer.all);
  if (!state_of_all) return null;
  const look = looks();
  const angles = Array.from({ length: 361 }, (_, i) => i - 180);
  const curve = (row, n) => ({ x: angles, y: angles.map(d => load_at(end_of(row), radians(d), n)) });
  const { azimuth = [], load: values } = answer.contact || {};
  // The load point by point has no waves where the rim is lifted.
  const points = azimuth.map((a, i) => [signed_degrees(a), values[i]]).sort((p, q) => p[0] - q[0]);
  const all = points.length ? { x: points.map(p => p[0]), y: points.map(p => p[1]) } : curve(answer.all);
  return {
    x: around(),
    y: { label: words().load_axis, zero: true, digits: '.4g' },
    marks: [
      line({ ...all, ...look.all }),
      end_of(answer.first_n) && line({ ...curve(answer.first_n, state.harmonics), ...look.first }),
      answer.paper.at_end && line({ ...curve(answer.paper), ...look.paper })
    ]
  };
}

function torque() {
  const { answer, curves } = found;
  if (!curves?.spin) return null;
  const look = looks();
  const curve = (list, more) => list && line({ x: curves.spin, y: numbers(list).map(v => 1e3 * v), ...more });
  const point = (row, { colour }) =>
    Number.isFinite(row?.omega) &&
    dots({ x: [row.omega], y: [0], colour, words: [[words().facts.omega, `${digits(row.omega, 6)} rad/s`]] });
  return {
    x: { label: words().omega_axis, symbol: 'ω =', room: 0 },
    y: { label: words().torque_axis, zero: true, digits: '.4g' },
    marks: [
      curve(curves.of_paper, look.paper),
      curve(curves.torque, look.all),
      curve(curves.of_n, look.first),
      point(answer.paper, look.paper),
      point(answer.all, look.all),
      point(answer.first_n, look.first)
    ]
  };
}

function spin() {
  const { curves, measured } = found;
  if (!curves?.time) return null;
  const look = looks();
  const curve = (list, more) => list?.length && line({ x: curves.time, y: numbers(list), ...more });
  return {
    x: { label: words().time, symbol: 't =', range: [0, curves.time[curves.time.length - 1]] },
    y: { label: words().omega_axis, zero: true, digits: '.5g' },
    marks: [
      curve(curves.omega_paper, look.paper),
      curve(curves.omega, look.all),
      curve(curves.omega_n, look.first),
      measured && dots({ ...measured, name: words().measured, colour: 'ink', hollow: true })
    ]
  };
}

function budget() {
  const rows = (found.budget?.rows || []).filter(row => Number.isFinite(row.omega));
  if (!rows.length) return null;
  const { steps, all } = words();
  const steps_shown = rows.filter((row, i) => i === 0 || Math.abs(row.difference || 0) > 1e-6);
  const title = ({ name, harmonics }) =>
    name !== 'harmonics' ? steps[name] || name : harmonics ? `n ≤ ${harmonics}` : all;
  const end = { omega: rows[rows.length - 1].omega };
  const titles = [...steps_shown.map(title), '='];
  const part = (colour, wanted) => {
    const picked = steps_shown.map((row, i) => ({ ...row, i })).filter(row => row.i > 0 && wanted(row.difference));
    return bars({
      colour,
      rows: picked.map(row => row.i),
      from: picked.map(row => row.omega - row.difference),
      to: picked.map(row => row.omega),
      texts: picked.map(title),
      words: picked.map(row => [title(row), `${shown(row.difference, '+.4g')} rad/s`])
    });
  };
  const ends = [steps_shown[0].omega, end.omega];
  const places = [0, titles.length - 1];
  return {
    x: { label: words().omega_axis, symbol: 'ω =', digits: '.6g', room: 0.08 },
    y: { rows: titles },
    edge: titles.map((_, i) =>
      places.includes(i) ? shown(ends[i && 1], '.5g') : shown(steps_shown[i].difference, '+.2g')
    ),
    marks: [
      part('c1', difference => difference < 0),
      part('c2', difference => difference >= 0),
      dots({
        x: ends,
        y: places,
        colour: 'ink',
        words: ends.map((v, i) => [titles[places[i]], `${digits(v, 6)} rad/s`])
      })
    ]
  };
}

/** The pressure in a strip around the contact, by azimuth and radius. */
function pressure() {
  const { answer, pressure: given } = found;
  if (!given?.cuts?.length || !answer.contact) return null;
  const { inner_radius: inner, outer_radius: outer } = answer.contact;
  const half = Math.max(0.75 * (outer - inner), 1e-6);
  const n = 40;
  const edges = Array.from({ length: n + 1 }, (_, k) => (inner + outer) / 2 + half * ((2 * k) / n - 1));
  const pressure_at = ([radii, values], r) => {
    const i = radii.findIndex(x => x > r);
    return i <= 0 ? 0 : values[i - 1] + ((values[i] - values[i - 1]) * (r - radii[i - 1])) / (radii[i] - radii[i - 1]);
  };
  const cuts = given.cuts
    .map((cut, i) => ({ cut, theta: signed_degrees(given.azimuth[i]) }))
    .sort((a, b) => a.theta - b.theta);
  const value = edges.slice(1).map((_, k) => cuts.map(({ cut }) => pressure_at(cut, (edges[k] + edges[k + 1]) / 2)));
  const most = Math.max(...value.flat());
  const [factor, unit] = most >= 1e6 ? [1e-6, 'MPa'] : [1e-3, 'kPa'];
  const turn = Array.from({ length: cuts.length + 1 }, (_, i) => -180 + (360 * i) / cuts.length);
  const mm = edges.map(r => 1e3 * r);
  const cells = grid(turn, mm, value.map(row => row.map(p => (p > 1e-3 * most ? factor * p : null)))); // prettier-ignore
  const colours = { range: [0, factor * most || 1], label: unit };
  const said = i => [
    `θ = ${shown(turn[i % cuts.length], '.4g')}°, r = ${shown(mm[Math.floor(i / cuts.length)], '.5g')} mm`,
    `p = ${shown(cells.value[i], '.4g')} ${unit}`
  ];
  return {
    x: around(),
    y: { label: words().radius, range: [mm[0], mm[n]], digits: '.5g' },
    colours,
    marks: [patches({ ...cells, colours, words: said })]
  };
}

/** What is drawn, by the name of its place on the page; null where there is nothing to draw. */
export const pictures = { load, torque, spin, budget, pressure };
/** Those that keep what they show while something moves. */
export const calm = ['torque', 'spin', 'budget', 'pressure'];

/** All harmonics against the first alone, as the budget has them; nothing where that does not spin. */
export function harmonic_effect() {
  const first = found.budget?.rows?.find(
    r => (r.harmonics === 1 && r.step >= 3 && r.name !== 'where the foot touches') || r.name === 'tilt'
  );
  const change = found.answer.all.omega / first?.omega - 1;
  return Number.isFinite(change) && Math.abs(first.omega) > 1e-6 ? shown(change, '+.2f%') : '–';
}
export const is_cut = () => state.harmonics < all_harmonics;
export const band_text = () => (pair().band || found.answer.fit === 'near' ? `±${shown(band(), '.2e')} rad/s` : '–');
