// What `stemware sweep` shows: curves or maps of the quantities of its table.
import { dots, line } from '../js/marks.js';
import { files, study } from './common.js';
import { grid, patches } from '../js/shapes.js';
import { shown } from '../js/words.js';

const parts_of = label => /^(.*?)(?: \((.*)\))?$/.exec(label).slice(1);
const axis_of = (label, log) => {
  const [name, unit] = parts_of(label);
  return { label: name, unit, log };
};

/** Edges of the cells round values: half-way between them on the axis. */
function edges_of(values, log) {
  const middle = (a, b) => (log ? Math.sqrt(a * b) : (a + b) / 2);
  const beyond = (a, b) => (log ? (a * a) / b : 2 * a - b);
  const inner = values.slice(1).map((v, i) => middle(v, values[i]));
  return [beyond(values[0], inner[0]), ...inner, beyond(values[values.length - 1], inner[inner.length - 1])];
}

function map_of(picture) {
  const { x, y, values, label } = picture;
  const known = values.flat().filter(Number.isFinite);
  let [low, high] = [Math.min(...known), Math.max(...known)];
  const both_signs = low < 0 && high > 0;
  if (both_signs) [low, high] = [-Math.max(-low, high), Math.max(-low, high)];
  const [axis_x, axis_y] = [
    axis_of(picture.x_label, picture.x_by_factors),
    axis_of(picture.y_label, picture.y_by_factors)
  ];
  const [edges_x, edges_y] = [edges_of(x, axis_x.log), edges_of(y, axis_y.log)];
  const colours = { range: [low, high], label, both_signs };
  const say = (axis, v) => `${axis.label} ${shown(v, '.5g')} ${axis.unit && axis.unit !== '1' ? axis.unit : ''}`.trim();
  const words = k => {
    const [i, j] = [k % x.length, Math.floor(k / x.length)];
    return [say(axis_x, x[i]), say(axis_y, y[j]), say(axis_of(label), values[j][i])];
  };
  const ends = edges => [edges[0], edges[edges.length - 1]].sort((a, b) => a - b);
  return {
    x: { ...axis_x, range: ends(edges_x) },
    y: { ...axis_y, range: ends(edges_y) },
    height: 340,
    colours,
    marks: [patches({ ...grid(edges_x, edges_y, values), colours, words })]
  };
}

function curves_of(picture) {
  const colours = ['c1', 'c2', 'c3', 'c4', 'c5', 'c6', 'c7', 'c8'];
  const dashes = [undefined, '8 4', '9 3 2 3', '3 3', '12 3', '9 3 2 3 2 3', '6 3', '2 2'];
  const number = list => list.map(v => v ?? NaN);
  return {
    x: axis_of(picture.x_label, picture.by_factors),
    y: { ...axis_of(picture.label), digits: '.5g' },
    marks: picture.curves.flatMap(({ name, x, y }, i) => {
      const look = { x: number(x), y: number(y), name, colour: colours[i % 8] };
      const few = x.length <= 40;
      return [
        line({ ...look, dash: dashes[i % 8] }),
        ...(few ? [{ ...dots({ ...look, size: 3 }), swatch: undefined, rows: () => [] }] : [])
      ];
    })
  };
}

function picture_of(doc, picture) {
  const notes =
    (doc.words.falls_over ? ' In cases without a terminal spin the glass tips over while it spins up.' : '') +
    (doc.words.one_way ? ' One-way: the load at rest is used at every spin.' : '');
  const [title, ...more] = picture.caption.replace(/\.$/, '').split(', ');
  const rest = more.join(', ');
  return {
    id: picture.id,
    title,
    words: `${picture.cases} cases`,
    caption: (rest && `${rest[0].toUpperCase()}${rest.slice(1)}.`) + notes,
    ...(picture.kind === 'map' ? map_of : curves_of)(picture)
  };
}

export function sweep(doc) {
  const { words, tables } = doc;
  return {
    title: words.title,
    inputs: words.inputs,
    answer: words.answer,
    sections: [
      {
        title: 'The cases',
        tables: [{ name: 'varied', title: 'Entries that differ from case to case' }],
        pictures: tables.pictures.map(picture => picture_of(doc, picture))
      },
      { title: 'Smallest and largest values', tables: [{ name: 'ranges' }] },
      tables.failures && {
        title: 'Cases that failed',
        text: 'sweep.csv lists all of them.',
        tables: [{ name: 'failures' }]
      },
      study(doc),
      files(doc)
    ]
  };
}
