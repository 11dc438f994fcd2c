// Tables of the document: headings, units and digits from summary.schema.json.
import { csv, heading_of, is_number, shown } from './words.js';
import { download, h, rich } from './dom.js';

/** Returns an object { key: values of the column }. */
export const columns = ({ keys, values }) => Object.fromEntries(keys.map((key, i) => [key, values[i]]));

/** Returns the keys listed in `wanted`, separated by blanks. "torques[]" selects all elements of the list torques. */
function chosen(keys, wanted) {
  if (!wanted) return keys;
  return wanted
    .split(' ')
    .flatMap(key => keys.filter(k => k === key || (key.endsWith('[]') && k.startsWith(key.slice(0, -1)))));
}

export const table_of = (headings, rows) => ({
  keys: headings,
  values: headings.map((_, k) => rows.map(row => row[k]))
});

/** Returns the table `name` of the document, or the table `given`, with the columns `keys`. */
export function table(doc, { name, keys, title, given = doc.tables[name] }) {
  const quantities = doc.quantities[name] || {};
  const shown_columns = chosen(given.keys, keys).map(key => {
    const quantity = { heading: key, unit: '', digits: '.6g', ...quantities[key] };
    const cells = given.values[given.keys.indexOf(key)];
    const texts = cells.map(value => shown(value, quantity.digits));
    return { quantity, cells, texts, is_number: texts.every(is_number) };
  });
  const n_rows = shown_columns[0]?.cells.length || 0;
  const rows = Array.from({ length: n_rows }, (_, i) => i);
  const headings = shown_columns.map(c => heading_of(c.quantity));
  const has_sentences = shown_columns.some(c => c.texts.some(text => text.length > 40));
  const save = () =>
    download(`${name}.csv`, csv([headings, ...rows.map(i => shown_columns.map(c => c.cells[i]))]), 'text/csv');
  const named = title || name.replace(/_/g, ' ');
  const button = h('button', { class: 'file', onclick: save, 'aria-label': `${named} as CSV` }, 'CSV');
  return h(
    'div',
    { class: 'wide', tabindex: 0, role: 'group', 'aria-label': named },
    h(
      'table',
      { class: has_sentences && 'sentences' },
      h('caption', {}, rich(title || ''), ' ', button),
      headings.some(Boolean) &&
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            shown_columns.map((c, i) => h('th', { scope: 'col', class: c.is_number && 'number' }, rich(headings[i])))
          )
        ),
      h(
        'tbody',
        {},
        rows.map(i =>
          h(
            'tr',
            {},
            shown_columns.map((c, k) =>
              h('td', { class: c.is_number && 'number', 'data-heading': headings[k] }, rich(c.texts[i]))
            )
          )
        )
      )
    )
  );
}
