// A picture as SVG, PNG and CSV.
import { csv, heading_of } from './words.js';
import { download, font, h, s } from './dom.js';

/** Colours of a picture for print. */
export const page_colours = {
  ink: '#1c1e21',
  soft: '#5b6067',
  line: '#c9ced5',
  grid: '#e6e9ed',
  card: '#ffffff',
  panel: '#f3f5f7',
  glass: '#7fa8c9',
  c1: '#0072b2',
  c2: '#d55e00',
  c3: '#00875f',
  c4: '#b0528a',
  c5: '#e69f00',
  c6: '#56b4e9',
  c7: '#1c1e21',
  c8: '#777777'
};

/** The text of an SVG file of nodes: light colours, nothing that needs the page. */
export function svg_text(title, description, nodes, width, height) {
  const svg = s(
    'svg',
    { xmlns: 'http://www.w3.org/2000/svg', viewBox: `0 0 ${width} ${height}`, width, height },
    s('title', {}, title),
    s('desc', {}, description),
    s('style', {}, `text{font:${font};fill:${page_colours.ink}}text.soft{fill:${page_colours.soft}}`),
    s('rect', { width, height, fill: page_colours.card }),
    nodes
  );
  return new XMLSerializer()
    .serializeToString(svg)
    .replace(/\u00a0/g, ' ')
    .replace(/var\(--([a-z0-9]+)\)/g, (_, name) => page_colours[name])
    .replace(/ (?:role|tabindex|aria-pressed|data-name|pointer-events|class)="(?!soft)[^"]*"/g, '');
}

export function standalone(figure, width = 480) {
  const { width: present, picture } = figure;
  const nodes = figure.draw(width);
  const height = figure.height;
  const text = svg_text(picture.title, picture.words || picture.caption || '', nodes, width, height);
  figure.redraw(present);
  return { text, width, height };
}

function table_of({ x = {}, y = {}, marks }) {
  const label = axis => heading_of({ heading: axis.label || '', unit: axis.unit });
  return csv([['curve', label(x) || 'x', label(y) || 'y'], ...marks.flatMap(m => m.rows())]);
}

function save(figure, kind) {
  const { id } = figure.picture;
  if (kind === 'CSV') return download(`${id}.csv`, table_of(figure.picture), 'text/csv');
  const { text, width, height } = standalone(figure);
  if (kind === 'SVG') return download(`${id}.svg`, text, 'image/svg+xml');
  const image = new Image();
  const canvas = h('canvas', { width: 3 * width, height: 3 * height });
  image.onload = () => {
    canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
    canvas.toBlob(blob => download(`${id}.png`, blob, 'image/png'));
  };
  image.src = 'data:image/svg+xml;charset=utf-8,' + encodeURIComponent(text);
}

export const buttons = figure =>
  h(
    'span',
    { class: 'files' },
    ['SVG', 'PNG', 'CSV'].map(kind =>
      h(
        'button',
        { class: 'file', 'aria-label': `${figure.picture.title} as ${kind}`, onclick: () => save(figure, kind) },
        kind
      )
    )
  );
