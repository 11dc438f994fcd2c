// Pictures of the chain of models: from the paper's terminal spin to that of the study.
import { bars, dots, rule } from '../js/marks.js';
import { columns } from '../js/tables.js';
import { line } from '../js/marks.js';
import { missing, shown } from '../js/words.js';

const spin = value => `${shown(value, '.6g')} rad/s`;
const one_way = ({ words }) => (words.one_way ? ' One-way: the load at rest is used at every spin.' : '');
const rounded = (value, rounding) => (Math.abs(value) < rounding ? 0 : value);

export function waterfall(doc) {
  const { rounding } = doc.words;
  const t = columns(doc.tables.waterfall);
  const last = t.row.length - 1;
  const rows = t.row.map((title, i) => ({
    title,
    i,
    omega: t.omega_terminal[i],
    difference: t.difference[i],
    before: t.omega_terminal[i] - t.difference[i],
    formal: t.formal[i]
  }));
  const faster = row => Math.abs(row.omega) > Math.abs(row.before);
  const words = row => [row.title, `${shown(rounded(row.difference, rounding), '+.4g')} rad/s → ${spin(row.omega)}`];
  const part = (name, colour, pale, wanted) => {
    const picked = rows.filter(row => row.difference !== null && wanted(row));
    return bars({
      name: picked.length ? name : '',
      colour,
      pale,
      rows: picked.map(r => r.i),
      from: picked.map(r => r.before),
      to: picked.map(r => r.omega),
      texts: picked.map(r => r.title),
      words: picked.map(words)
    });
  };
  const ends = [0, last].filter(i => t.omega_terminal[i] !== null);
  const banded = rows.filter(row => t.band[row.i] > 0);
  return {
    id: 'waterfall',
    title: 'From the paper’s spin to this study’s',
    words: `${spin(t.omega_terminal[0])} to ${spin(t.omega_terminal[last])}`,
    caption:
      'Each step adds one effect to the model of the row above; the numbers are the changes in rad/s.' + one_way(doc),
    x: { label: 'terminal spin', symbol: 'ω =', unit: 'rad/s', digits: '.6g', room: 0.08 },
    y: { rows: t.row },
    marks: [
      part('faster', 'c1', false, row => !row.formal && faster(row)),
      part('slower', 'c5', false, row => !row.formal && !faster(row)),
      part('faster, formally', 'c1', true, row => row.formal && faster(row)),
      part('slower, formally', 'c5', true, row => row.formal && !faster(row)),
      dots({
        name: banded.length ? 'error band' : '',
        colour: 'ink',
        size: 0,
        across: true,
        x: banded.map(row => row.omega),
        y: banded.map(row => row.i),
        band: banded.map(row => t.band[row.i])
      }),
      dots({
        x: ends.map(i => t.omega_terminal[i]),
        y: ends,
        colour: 'ink',
        size: 5,
        words: ends.map(i => [t.row[i], spin(t.omega_terminal[i])])
      })
    ],
    edge: rows.map(({ i, omega, difference }) =>
      i === 0 || i === last
        ? shown(omega, '.6g')
        : difference === null
          ? missing
          : shown(rounded(difference, rounding), '+.3g')
    )
  };
}

/** How large each effect is: steps of the model, and what leaving out one thing changes. */
export function effects(doc) {
  const { band, rounding } = doc.words;
  const t = columns(doc.tables.effects);
  if (!t.row?.length) return null;
  const part = (name, colour, shape, is_step) => {
    const picked = t.row
      .map((title, i) => ({ title, i, difference: t.difference[i] }))
      .filter(row => t.is_step[row.i] === is_step && Math.abs(row.difference) >= rounding);
    return dots({
      name: picked.length ? name : '',
      colour,
      shape,
      size: 5,
      x: picked.map(row => Math.abs(row.difference)),
      y: picked.map(row => row.i),
      words: picked.map(row => [row.title, `${shown(row.difference, '+.4g')} rad/s`])
    });
  };
  const number = i => {
    if (t.difference[i] === null) return t.is_defined[i] ? missing : 'not defined';
    return shown(rounded(t.difference[i], rounding), '+.3g');
  };
  return {
    id: 'effects',
    title: 'How large each effect is',
    words: t.row.map((row, i) => `${row} ${number(i)}`).join(', '),
    caption:
      'Steps from the paper’s model to this study’s, and the complete model without one effect at a time, in rad/s. ' +
      'The error band of the terminal spin contains none of them.' +
      one_way(doc),
    x: { label: '|difference of terminal spins|', unit: 'rad/s', log: true, digits: '.3g' },
    y: { rows: t.row },
    marks: [
      part('steps of the model', 'c1', 'dot', true),
      part('one effect left out', 'c2', 'square', false),
      ...(band > 0 ? [rule({ x: band, name: 'error band', dash: '4 3' })] : [])
    ],
    edge: t.row.map((_, i) => number(i))
  };
}

/** A factor and a unit in which torques of this size are short. */
const torque_unit = size => (size >= 1e-4 ? [1e3, 'mN m'] : size >= 1e-7 ? [1e6, 'µN m'] : [1e9, 'nN m']);
const largest = list => Math.max(...list.map(v => Math.abs(v) || 0));

/** Torque of all harmonics and of the first, and their difference. */
export function harmonic_torque(doc) {
  const t = columns(doc.tables.harmonic_torque);
  const [factor, unit] = torque_unit(largest([...t.all, ...t.first]));
  const [fine, fine_unit] = torque_unit(largest(t.difference));
  const curve = (key, name, colour, dash, k) => line({ x: t.omega, y: t[key].map(v => v * k), name, colour, dash });
  const x = { label: 'spin ω', symbol: 'ω =', unit: 'rad/s', room: 0 };
  return [
    {
      id: 'harmonic_torque',
      title: 'Torque of friction against the spin',
      words: `${shown(doc.words.numbers.torque_at_rest, '.3g')} N m at rest`,
      caption: 'All harmonics of the load, and the first only.' + one_way(doc),
      x,
      y: { label: 'torque τ_z', unit, zero: true, digits: '.4g' },
      marks: [
        curve('first', 'first harmonic', 'c2', '8 4', factor),
        curve('all', 'all harmonics', 'c1', undefined, factor)
      ]
    },
    {
      id: 'torque_of_harmonics',
      title: 'Torque of the harmonics beyond the first',
      words: `at most ${shown(largest(t.difference), '.2g')} N m`,
      caption: 'Difference between the two torque curves.' + one_way(doc),
      x,
      y: { label: 'Δτ_z', unit: fine_unit, zero: true, digits: '.4g' },
      marks: [curve('difference', '', 'c3', undefined, fine)]
    }
  ];
}
