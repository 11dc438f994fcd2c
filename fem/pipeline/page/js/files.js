// Drawings, and export of pictures as SVG, PNG and CSV.
import { csv, heading_of, label_of } from './words.js';
import { download, font, h, rich, s } from './dom.js';

const colour = name => document.styleSheets[0].cssRules[0].style.getPropertyValue(name).trim();

/** Returns the text of a self-contained SVG file of the nodes, in light colours. */
export function svg_text(title, description, nodes, width, height) {
  const svg = s(
    'svg',
    { xmlns: 'http://www.w3.org/2000/svg', viewBox: `0 0 ${width} ${height}`, width, height },
    s('title', {}, title),
    s('desc', {}, description),
    s('style', {}, `text{font:${font};fill:${colour('--ink')}}text.soft{fill:${colour('--soft')}}`),
    s('rect', { width, height, fill: colour('--card') }),
    nodes
  );
  return new XMLSerializer()
    .serializeToString(svg)
    .replace(/\u00a0/g, ' ')
    .replace(/var\((--[a-z0-9]+)\)/g, (_, name) => colour(name))
    .replace(/ (?:role|tabindex|aria-pressed|data-name|pointer-events|class)="(?!soft|round)[^"]*"/g, '');
}

/** Returns a drawing with its caption: { id, node, alone() }. `style`: style rules of its SVG file. */
export function drawing({ id, heading, caption, title, svg, style = '' }) {
  const text = h('figcaption', {}, h('b', {}, `${heading}. `), rich(caption));
  return { id, node: h('figure', { id, class: 'drawing' }, svg, text), alone: () => copy_of(svg, title, caption, style) };
}

export function copy_of(svg, title, description, style) {
  const { width, height } = svg.viewBox.baseVal;
  const nodes = [...svg.childNodes].map(child => child.cloneNode(true));
  return { text: svg_text(title, description, [style && s('style', {}, style), nodes], width, height), width, height };
}

/** Returns the values in `extra` of a mark, by heading with unit. */
export const extra_of = (mark, axes) =>
  Object.fromEntries(
    (mark.extra || []).map(({ heading, axis, values }) => [heading_of({ heading, unit: axes[axis]?.unit }), values])
  );

function table_of({ x = {}, y = {}, marks }) {
  const further = [...new Set(marks.filter(m => m.rows().length).flatMap(m => Object.keys(extra_of(m, { x, y }))))];
  const rows_of = mark => {
    const extra = extra_of(mark, { x, y });
    return mark.rows().map((row, i) => [...row, ...further.map(heading => extra[heading]?.[i])]);
  };
  return csv([['curve', label_of(x) || 'x', label_of(y) || (y.rows ? 'row' : 'y'), ...further], ...marks.flatMap(rows_of)]);
}

function save(figure, kind) {
  const { id } = figure.picture;
  if (kind === 'CSV') return download(`${id}.csv`, table_of(figure.picture), 'text/csv');
  const { text, width, height } = figure.alone(480);
  if (kind === 'SVG') return download(`${id}.svg`, text, 'image/svg+xml');
  const image = new Image();
  const canvas = h('canvas', { width: 3 * width, height: 3 * height });
  image.onload = () => {
    canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
    canvas.toBlob(blob => download(`${id}.png`, blob, 'image/png'));
  };
  image.src = 'data:image/svg+xml;charset=utf-8,' + encodeURIComponent(text);
}

export const buttons = figure => {
  const named = kind => ({ class: 'file', 'aria-label': `${figure.picture.title} as ${kind}` });
  const button = kind => h('button', { ...named(kind), onclick: () => save(figure, kind) }, kind);
  return h('span', { class: 'files' }, ['SVG', 'PNG', 'CSV'].map(button));
};
