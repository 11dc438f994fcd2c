// Pictures of the chain of models: from the paper's terminal spin to the study's.
import { bars, dots, rule } from '../js/marks.js';
import { missing, shown } from '../js/words.js';
import { one_way } from './spin.js';

const spin = value => `${shown(value, '#.4g')} rad/s`;
const rounded = (value, rounding) => (Math.abs(value) < rounding ? 0 : value);

/** Returns the steps of the budget with their titles. The last step is the study. */
function steps_of({ tables }) {
  const steps = tables.waterfall.map(row => {
    const formal = row.state === 'formal';
    return { ...row, formal, title: row.name + (formal ? ' (formal)' : '') };
  });
  const end = { ...steps[steps.length - 1], title: 'this study', difference: null, formal: false };
  const [first, ...more] = steps;
  const title = "the paper's model" + (first.formal ? ' (formal)' : '');
  return [{ ...first, title, difference: null }, ...more, end];
}

export function waterfall(doc) {
  const { rounding } = doc.words;
  const rows = steps_of(doc).map((row, i) => ({
    ...row,
    i,
    omega: row.omega_terminal,
    before: row.omega_terminal - row.difference
  }));
  const titles = rows.map(row => row.title);
  const last = rows.length - 1;
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
  const ends = [rows[0], rows[last]].filter(row => row.omega !== null);
  const banded = rows.filter(row => row.band > 0);
  return {
    id: 'waterfall',
    title: 'From the paper’s spin to this study’s',
    words: `${spin(rows[0].omega)} to ${spin(rows[last].omega)}`,
    caption:
      'Each step adds one effect to the model of the row above; the numbers are the changes in rad/s.' + one_way(doc),
    x: { label: 'terminal spin', symbol: 'ω =', unit: 'rad/s', digits: '#.4g', room: 0.08 },
    y: { rows: titles },
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
        band: banded.map(row => row.band)
      }),
      dots({
        x: ends.map(row => row.omega),
        y: ends.map(row => row.i),
        colour: 'ink',
        size: 5,
        words: ends.map(row => [row.title, spin(row.omega)])
      })
    ],
    edge: rows.map(({ i, omega, difference }) =>
      i === 0 || i === last
        ? shown(omega, '#.4g')
        : difference === null
          ? missing
          : shown(rounded(difference, rounding), '+.3g')
    )
  };
}

export function effects(doc) {
  const { budget, without } = doc.summary;
  const { rounding } = doc.words;
  const { band } = budget[budget.length - 1];
  const steps = doc.tables.waterfall
    .slice(1)
    .map(({ name, difference }) => ({ title: name, difference, is_step: true }));
  const left_out = without.map(({ name, difference, reason }) => ({ title: `without ${name}`, difference, reason }));
  const rows = [...steps, ...left_out].map((row, i) => ({ ...row, i }));
  if (!rows.length) return null;
  const part = (name, colour, shape, is_step) => {
    const picked = rows.filter(row => Boolean(row.is_step) === is_step && Math.abs(row.difference) >= rounding);
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
  const number = ({ difference, reason }) => {
    if (difference === null) return reason === 'not defined' ? reason : missing;
    return shown(rounded(difference, rounding), '+.3g');
  };
  return {
    id: 'effects',
    title: 'How large each effect is',
    words: rows.map(row => `${row.title} ${number(row)}`).join(', '),
    caption:
      'Steps from the paper’s model to this study’s, and the complete model without one effect at a time, in rad/s. ' +
      'The error band of the terminal spin contains none of them.' +
      one_way(doc),
    x: { label: '|difference of terminal spins|', unit: 'rad/s', log: true, digits: '.3g' },
    y: { rows: rows.map(row => row.title) },
    marks: [
      part('steps of the model', 'c1', 'dot', true),
      part('one effect left out', 'c2', 'square', false),
      ...(band > 0 ? [rule({ x: band, name: 'error band', dash: '4 3' })] : [])
    ],
    edge: rows.map(number)
  };
}
