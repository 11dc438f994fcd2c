// What can be taken along, and what was measured.
import { data, doc, pair, state } from './state.js';
import { csv } from '../js/words.js';
import { download } from '../js/dom.js';
import { label_of } from '../js/figure.js';

/** Points of all curves: which picture and curve, what x and y are, and x and y. */
export function save_curves(drawn) {
  const rows = [...drawn].flatMap(({ id, x, y, marks }) =>
    marks.flatMap(mark =>
      mark.rows().map(([curve, at, value]) => [id, curve, label_of(x || {}), label_of(y || {}), at, value])
    )
  );
  download('explored.csv', csv([['picture', 'curve', 'x is', 'y is', 'x', 'y'], ...rows]), 'text/csv');
}

/** The study as a file of parameters. */
export function study_text() {
  const values = { ...Object.fromEntries(pair().values), ...state.changes };
  const line = text => text.replace(/[\r\n]+/g, ' ');
  const sections = new Map();
  for (const path in values) {
    const [section, ...name] = path.split('/').map(line);
    sections.set(section, [...(sections.get(section) || []), `  set ${name.join('/')} = ${line(values[path])}`]);
  }
  const omega = doc.summary.ring?.omega_terminal;
  return [
    `# ${state.glass} on ${state.table}, from the page of Stemware ${data.version}`,
    '#\n#   stemware run explored.prm',
    Number.isFinite(omega) ? `#\n# The page's terminal spin: ${omega} rad/s` : '#',
    ...[...sections].map(([section, lines]) => `\nsubsection ${section}\n${lines.join('\n')}\nend`),
    ''
  ].join('\n');
}

/**
 * Rows of time and spin, or time and angle (a head that says angle, psi or deg); decimals by point, or by comma where columns
 * are by semicolon. Nothing where there are none.
 */
export function read_measured(text) {
  const lines = text
    .split(/\r?\n/)
    .map(line => line.trim())
    .filter(line => line && !line.startsWith('#'));
  const head = lines.find(line => /[a-z]/i.test(line.replace(/e[-+]?\d/gi, ''))) || '';
  const cells = line => (line.includes(';') ? line.replace(/,/g, '.').split(';') : line.split(/[,\t ]+/));
  const rows = lines
    .map(line => cells(line).map(Number))
    .filter(row => row.length >= 2 && row.slice(0, 2).every(Number.isFinite));
  if (rows.length < 2) return null;
  const factor = /deg|°/i.test(head) ? Math.PI / 180 : /rpm|1\/min/i.test(head) ? Math.PI / 30 : 1;
  const x = rows.map(row => row[0]);
  const y = rows.map(row => row[1] * factor);
  if (!/angle|psi|winkel|ψ/i.test(head)) return { x, y };
  const steps = x.map((_, i) => i).filter(i => i > 0 && x[i] > x[i - 1]);
  return { x: steps.map(i => (x[i] + x[i - 1]) / 2), y: steps.map(i => (y[i] - y[i - 1]) / (x[i] - x[i - 1])) };
}
