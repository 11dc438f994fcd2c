// Downloads of the live page: curves, the page itself, the study.
import { data, doc, pair, parts_of_state, state } from './state.js';
import { csv, label_of } from '../js/words.js';
import { download } from '../js/dom.js';
import { extra_of } from '../js/files.js';

/**
 * Downloads the points of all curves as CSV: picture, curve, meaning of x and y, x, y, and the heading and value of a
 * colour or band.
 */
export function save_curves(drawn) {
  const rows = [...drawn].flatMap(({ id, x, y, marks }) =>
    marks.flatMap(mark => {
      const [heading, values] = Object.entries(extra_of(mark, { x, y }))[0] || ['', []];
      return mark.rows().map(([curve, ...at], i) => [id, curve, label_of(x || {}), label_of(y || {}), ...at, heading, values[i]]);
    })
  );
  download(
    'explored.csv',
    csv([['picture', 'curve', 'x is', 'y is', 'x', 'y', 'value is', 'value'], ...rows]),
    'text/csv'
  );
}

/** Returns `page`, the original text of this page, with the current state, for download. */
export const page_with_state = page =>
  '<!doctype html>\n' +
  page.replace(/id="live"( data-state="[^"]*")?/, () => `id="live" data-state="${String(parts_of_state()).replace(/&/g, '&amp;')}"`);

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
