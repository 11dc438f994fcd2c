// Pictures of torque, spin-up and harmonics.
import { columns } from '../js/tables.js';
import { dots, line, marked, rule } from '../js/marks.js';
import { shown } from '../js/words.js';

const looks = {
  all: ['all harmonics', 'c1'],
  up_to_1: ['first harmonic', 'c2', '8 4'],
  up_to_2: ['n ≤ 2', 'c3', '9 3 2 3'],
  up_to_3: ['n ≤ 3', 'c4', '3 3'],
  paper: ['the paper’s model', 'c5', '9 3 2 3 2 3']
};
/** Returns name, colour and dash of the curve `key`: all, paper, or up_to_n for n harmonics. */
export const look_of = key => looks[key] || [key.replace('up_to_', 'n ≤ '), 'c4', '3 3'];
/** Returns the keys of the curves in a table. The last key is the complete study. */
const curve_keys = t =>
  ['paper', ...Object.keys(t).filter(key => key.startsWith('up_to_')), 'all'].filter(key => t[key]);
export const one_way = ({ words }) => (words.one_way ? ' One-way: the load at rest is used at every spin.' : '');
const in_millinewton = list => list.map(v => (v === null ? NaN : 1e3 * v));

/** Returns the terminal spins to draw: [key of the curve, spin, number of harmonics]. */
function terminal_points({ truncation, first_n, ring }) {
  const rows = truncation || [first_n, ring].filter(Boolean);
  return rows
    .map((row, i) => [i === rows.length - 1 ? 'all' : `up_to_${row.harmonics}`, row.omega_terminal, row.harmonics])
    .filter(([key, omega, n]) => Number.isFinite(omega) && (key === 'all' || n <= 3 || rows.length === 2));
}

export function torque(doc) {
  const t = columns(doc.tables.torque);
  const { spin_unit } = doc.words;
  const only_one = Object.keys(t).length === 2;
  const curves = curve_keys(t);
  const look = key => (only_one ? ['', 'c1'] : look_of(key));
  return {
    id: 'torque',
    title: 'Torque of friction against the spin by the number of harmonics',
    words: `${shown(doc.summary.ring.tau_at_rest, '.3g')} N m at rest`,
    caption:
      'n harmonics kept. Points: terminal spins, zeros of the sum of friction, lean and grip torque.' +
      ` Beyond ω = ±v/R = ±${shown(spin_unit, '.3g')} rad/s a part of the rim slides backwards.` +
      one_way(doc),
    x: { label: 'spin ω', symbol: 'ω =', unit: 'rad/s', room: 0, range: [t.omega[0], t.omega[t.omega.length - 1]] },
    y: { label: 'torque τ_z', unit: 'mN m', zero: true, digits: '.4g' },
    marks: [
      ...curves.map(key => {
        const [name, colour, dash] = look(key);
        return line({ x: t.omega, y: in_millinewton(t[key]), name, colour, dash });
      }),
      ...terminal_points(doc.summary).map(([key, omega]) => {
        const [name, colour] = look(key);
        const words = [[name || 'all harmonics', `ω = ${shown(omega, '#.4g')} rad/s`]];
        return dots({ x: [omega], y: [0], colour, name, words });
      }),
      ...[-spin_unit, spin_unit]
        .filter(x => (x - t.omega[0]) * (x - t.omega[t.omega.length - 1]) <= 0)
        .map(x => rule({ x, text: x > 0 ? 'v/R' : '−v/R', dash: '2 3' }))
    ]
  };
}

/** Returns factor and unit that give short numbers for torques of magnitude `size` [N m]. */
const torque_unit = size => (size >= 1e-4 ? [1e3, 'mN m'] : size >= 1e-7 ? [1e6, 'µN m'] : [1e9, 'nN m']);
const largest = list => Math.max(...list.map(v => Math.abs(v) || 0));

/** Shows the torque of all harmonics minus the torque of the first harmonic; null at rounding level. */
export function torque_of_harmonics(doc) {
  const { omega, all, up_to_1: first } = columns(doc.tables.torque);
  if (!first) return null;
  const difference = all.map((v, i) => (v === null || first[i] === null ? NaN : v - first[i]));
  const size = largest(difference);
  if (!(size > 1e-5 * largest(all))) return null;
  const [factor, unit] = torque_unit(size);
  return {
    id: 'torque_of_harmonics',
    title: 'Torque of the harmonics beyond the first',
    words: `at most ${shown(size, '.2g')} N m`,
    caption: 'Difference between the two torque curves.' + one_way(doc),
    x: { label: 'spin ω', symbol: 'ω =', unit: 'rad/s', room: 0 },
    y: { label: 'Δτ_z', unit, zero: true, digits: '.4g' },
    marks: [line({ x: omega, y: difference.map(v => v * factor), colour: 'c3' })]
  };
}

export function spin_up(doc) {
  const t = columns(doc.tables.spin_up);
  const { ring } = doc.summary;
  const measured = doc.tables.measured && columns(doc.tables.measured);
  const known = Number.isFinite(ring.omega_terminal);
  const last = t.time[t.time.length - 1];
  const settles = known && ring.time_constant > 0 && ring.time_constant < last;
  return {
    id: 'spin_up',
    title: 'Spin-up from rest',
    words: `to ${shown(ring.omega_terminal ?? ring.fall?.omega, '.4g')} rad/s`,
    caption:
      `${known ? `The terminal spin is ${shown(ring.omega_terminal, '#.4g')} rad/s, ${shown(Math.abs(ring.omega_terminal) / (2 * Math.PI), '.3g')} turns per second.` : ''}` +
      (settles ? ' Dotted: time constant of the approach to the terminal spin.' : '') +
      one_way(doc),
    x: { label: 'time', symbol: 't =', unit: 's', room: 0, range: measured ? [0, last] : undefined },
    y: { label: 'spin ω', unit: 'rad/s', zero: true },
    marks: [
      measured && dots({ x: measured.time, y: measured.omega, name: 'measured', colour: 'ink', hollow: true }),
      ...curve_keys(t).map(key => {
        const [name, colour, dash] = look_of(key);
        return line({ x: t.time, y: t[key].map(v => v ?? NaN), name, colour, dash });
      }),
      known && rule({ y: ring.omega_terminal, colour: 'c8', dash: '1 3' }),
      settles &&
        rule({
          x: ring.time_constant,
          text: `${shown(ring.time_constant, '.3g')} s`,
          dash: '2 3',
          low: ring.omega_terminal > 0
        })
    ].filter(Boolean)
  };
}

export function driven(doc) {
  if (!doc.tables.driven) return [];
  const t = columns(doc.tables.driven);
  const constant = columns(doc.tables.spin_up);
  const x = { label: 'time', symbol: 't =', unit: 's', room: 0 };
  return [
    {
      id: 'driven_spin_up',
      title: 'Spin-up under the hand’s speed',
      words: `${shown(doc.summary.ring.driven.omega_at_end, '.4g')} rad/s at the end`,
      caption: 'Compared with the spin-up at constant speed.',
      x,
      y: { label: 'spin ω', unit: 'rad/s', zero: true },
      marks: [
        line({ x: constant.time, y: constant.all, name: 'constant v', colour: 'c2', dash: '8 4' }),
        line({ x: t.time, y: t.omega, name: 'v(t)' })
      ]
    },
    {
      id: 'orbit_speed',
      title: 'The speed of the hand',
      words: `${shown(Math.min(...t.speed), '.3g')} to ${shown(Math.max(...t.speed), '.3g')} m/s`,
      x,
      y: { label: 'v', unit: 'm/s', zero: true },
      marks: [line({ x: t.time, y: t.speed })]
    }
  ];
}

export function phases(doc) {
  const t = columns(doc.tables.phases);
  const words = (key, i) => [`θ = ${shown(t.theta[i], '.4g')}°`, `τ_z = ${shown(1e3 * t[key][i], '.5g')} mN m`];
  const part = (key, name, colour) =>
    dots({ x: t.theta, y: in_millinewton(t[key]), name, colour, words: t.theta.map((_, i) => words(key, i)) });
  return {
    id: 'phases',
    title: 'Torque over the phase',
    words: `±${shown(doc.summary.waviness.torque_ripple, '.2g')} N m`,
    caption: `Torque of friction over the azimuth of the mark of the ${doc.words.marked}, at rest and at the mean spin over time; periodic.`,
    x: { label: 'θ from the direction of travel', symbol: 'θ =', unit: '°' },
    y: { label: 'torque τ_z', unit: 'mN m' },
    marks: [part('at_rest', 'at rest', 'c1'), part('at_terminal', 'at the mean spin', 'c2')]
  };
}

/** Shows the effect of the harmonics 2 … n on the torque over the spin; null at rounding level. */
export function torque_changes(doc) {
  const t = columns(doc.tables.torque_changes);
  const rest = Math.abs(doc.summary.truncation[0].tau_at_rest);
  const orders = Object.keys(t).filter(key => key !== 'omega');
  const all = orders[orders.length - 1];
  if (!all || !(largest(t[all]) > 1e-9 * rest)) return null;
  // Curves that coincide with the curve of all harmonics are omitted.
  const differs = n => largest(t[n].map((v, i) => v - t[all][i])) > 0.01 * largest(t[all]);
  const shown_orders = [...orders.filter(differs).slice(0, 4), all];
  const colours = ['c2', 'c3', 'c4', 'c5'];
  const dashes = ['8 4', '9 3 2 3', '3 3', '9 3 2 3 2 3'];
  const part = (n, i) =>
    line({
      x: t.omega,
      y: t[n].map(v => (v === null ? NaN : (100 * v) / rest)),
      name: n === all ? 'all harmonics' : `n ≤ ${n}`,
      colour: n === all ? 'c1' : colours[i],
      dash: n === all ? undefined : dashes[i]
    });
  return {
    id: 'torque_changes',
    title: 'Effect of the harmonics beyond the first on the torque',
    words: `${shown((100 * doc.summary.torque_effect.half) / rest, '+.3g')} % at half the terminal spin`,
    caption:
      'Δτ_z(n) = τ_z(n) − τ_z(1) of friction: the load of the complete study at each spin, cut after n harmonics, ' +
      'without a new balance. Relative to the torque at rest.' +
      one_way(doc),
    x: { label: 'spin ω', symbol: 'ω =', unit: 'rad/s' },
    y: { label: 'Δτ_z(n) / |τ_z(0)|', unit: '%', zero: true, digits: '.3g' },
    marks: shown_orders.map(part)
  };
}

export function truncation(doc) {
  const rows = doc.summary.truncation.filter(row => Math.abs(row.relative_change) > 1e-12); // omits rounding errors
  if (rows.length < 3) return null;
  const x = rows.map(row => row.harmonics);
  const y = rows.map(row => Math.abs(row.relative_change));
  return {
    id: 'truncation',
    title: 'Change of the terminal spin by the number of harmonics',
    caption: 'Change without the harmonics beyond n, relative to the spin with all harmonics.' + one_way(doc),
    x: { label: 'harmonics kept', symbol: 'n =', ticks: Math.max(...x) <= 8 ? x : undefined },
    y: { label: '|Δω / ω|', log: true, digits: '.3g' },
    marks: marked({ x, y })
  };
}
