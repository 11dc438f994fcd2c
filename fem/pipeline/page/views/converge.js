// Page of `stemware converge`.
import { bands, beginning, files, study } from './common.js';
import { marked } from '../js/marks.js';
import { shown } from '../js/words.js';

/** Returns curves of |spin / limit - 1| of each axis over its levels. */
function curves_of({ summary, words }) {
  return Object.values(summary.refinement).map(({ name, own_level, figures }) => {
    const { values, limit } = figures.omega_terminal;
    const rows = values
      .map((value, l) => [l - own_level, Math.abs(value - limit)])
      .filter(row => row[1] > words.rounding);
    return { name, level: rows.map(row => row[0]), error: rows.map(row => row[1] / Math.abs(limit)) };
  });
}

function convergence(doc) {
  const colours = ['c1', 'c2', 'c3', 'c4', 'c5', 'c6'];
  const curves = curves_of(doc).filter(curve => curve.level.length);
  const levels = [...new Set(curves.flatMap(curve => curve.level))].sort((a, b) => a - b);
  const { value, band } = doc.summary.error_bands.omega_terminal;
  return {
    id: 'convergence',
    title: 'Distance of the terminal spin from its limit',
    words: `the terminal spin is ${shown(value)} ± ${shown(band, 'band')} rad/s`,
    caption:
      'Relative distance by axis and level; 0 is the study’s own level. Levels that agree with the limit to the tolerance of the ' +
      'solver are not drawn.',
    x: { label: 'level, finer to the right', symbol: 'level', ticks: levels, room: 0.08 },
    y: { label: 'relative error', log: true, digits: '.3g' },
    marks: curves.flatMap(({ name, level, error }, i) => marked({ x: level, y: error, name, colour: colours[i % 6] }))
  };
}

export function converge(doc) {
  const { refinement, error_bands } = doc.summary;
  const { order } = Object.values(refinement)[0].figures.omega_terminal;
  const no_order =
    'No order is observed if the errors are below the tolerance of the contact solver, or not yet asymptotic; a coarser ' +
    'study shows one (--set Contact/Degree=1).';
  return {
    ...beginning(doc, [{ title: 'this glass', omega: error_bands.omega_terminal.value }]),
    sections: [
      {
        title: 'Discretisation error',
        text: order === null && no_order,
        pictures: [convergence(doc)],
        tables: [{ name: 'spin_bands', title: 'Error band of the terminal spin, axis by axis' }]
      },
      bands(doc),
      study(doc),
      files(doc)
    ]
  };
}
