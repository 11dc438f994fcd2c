// A page from a view: { title, inputs, answer, head: [pictures], sections: [{ title, folded, text, pictures, tables, files }] }.
import { Figure } from './figure.js';
import { h, rich } from './dom.js';
import { table } from './tables.js';
import { without_rounding } from './rounding.js';

const figures = new Map();
const fit = ({ target, contentRect }) => {
  const figure = figures.get(target.id);
  const width = Math.round(contentRect.width);
  if (figure && width > 0 && width !== figure.width) figure.redraw(width);
};
// Deferred to the next frame: browsers report an error if a callback of ResizeObserver changes sizes.
const resized = new ResizeObserver(entries => requestAnimationFrame(() => entries.forEach(fit)));

export function figure_of(picture) {
  if (picture.node) {
    figures.set(picture.id, picture); // a drawing with its own rendering
    return picture.node;
  }
  const figure = new Figure(picture);
  figures.set(picture.id, figure);
  resized.observe(figure.node);
  return figure.node;
}

/** Replaces the picture with the same id. Returns false if no picture has this id. */
export function show_anew(picture) {
  figures.get(picture.id)?.set(picture);
  return figures.has(picture.id);
}

const there = list => (list || []).flat(3).filter(Boolean);
const paragraphs = text => there([text]).map(words => h('p', {}, rich(words)));
const file_of = ([name, words]) => [h('dt', {}, h('a', { href: encodeURI(name) }, name)), h('dd', {}, rich(words))];
const files_of = files => files && h('dl', {}, files.map(file_of));

function section_of(doc, { title, folded, text, pictures, tables, files }) {
  const content = [
    paragraphs(text),
    there(pictures).length ? h('div', { class: 'figures' }, there(pictures).map(figure_of)) : [],
    there(tables)
      .filter(t => (t.given || doc.tables[t.name])?.values[0]?.length)
      .map(t => table(doc, t)),
    files_of(files)
  ];
  const heading = h('h2', {}, rich(title));
  return h('section', {}, folded ? h('details', {}, h('summary', {}, heading), content) : [heading, content]);
}

function show(doc, view, main) {
  const head = there(view.head).map(figure_of);
  const sections = there(view.sections).map(section => section_of(doc, section));
  const { version, revision } = doc.summary.program;
  document.title = view.title;
  main.replaceChildren(
    h('h1', {}, rich(view.title)),
    view.inputs ? h('p', { class: 'inputs' }, rich(view.inputs)) : '',
    head.length ? h('div', { class: 'figures head' }, head) : '',
    h('p', { class: 'answer' }, rich(view.answer)),
    ...sections,
    h('footer', {}, `Stemware ${version} (${revision})`)
  );
}

export function show_document(views) {
  const doc = JSON.parse(document.getElementById('document').textContent);
  without_rounding(doc);
  show(doc, views[doc.summary.verb](doc), document.querySelector('main'));
}

/** Shows a single picture instead of the page, for automatic export: report.html#svg=torque. */
export function show_alone(id, width) {
  const { text, height } = figures.get(id).alone(width);
  const parsed = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
  const body = 'body { margin: 0; padding: 0; max-width: none } svg { display: block }';
  document.head.append(h('style', {}, `@page { size: ${width}px ${height}px; margin: 0 } ${body}`));
  document.body.replaceChildren(parsed);
}

addEventListener('beforeprint', () => figures.forEach(figure => figure.redraw?.(360)));
addEventListener('afterprint', () => figures.forEach(figure => figure.redraw?.(figure.node.clientWidth || 480)));
