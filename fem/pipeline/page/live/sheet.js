// The class sheet of the lesson: a printed page of this file.
import { $ } from './state.js';
import { h } from '../js/dom.js';
import { sheet_texts as t } from './sheet_texts.js';

const table = (head, rows) =>
  h('table', {}, h('thead', {}, h('tr', {}, head.map(text => h('th', {}, text)))), h('tbody', {}, rows.map(text => h('tr', {}, head.map((_, i) => h('td', {}, i ? '' : text)))))); // prettier-ignore

/** Prints the sheet only. */
export function print_sheet() {
  $('sheet').replaceChildren(
    h('h1', {}, t.title),
    h('p', {}, t.question),
    ...t.parts.flatMap(({ title, text, head, rows, list }) => [
      h('h2', {}, title),
      h('p', {}, text),
      head ? table(head, rows) : h('ol', {}, list.map(item => h('li', {}, item)))
    ])
  );
  $('sheet').hidden = false;
  document.body.dataset.sheet = '';
  print();
  delete document.body.dataset.sheet;
  $('sheet').hidden = true;
}
