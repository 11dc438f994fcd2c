// Pictures of the load on the table and of its friction.
import { arrows, outline, strokes } from '../js/shapes.js';
import { columns, table_of } from '../js/tables.js';
import { dots, line, note, rule } from '../js/marks.js';
import { look_of } from './spin.js';
import { pressing, truncated, value_of } from '../js/series.js';
import { shown } from '../js/words.js';

const turn = Array.from({ length: 121 }, (_, i) => (2 * Math.PI * i) / 120);
export const radians = degrees => (degrees * Math.PI) / 180;
export const circle = (radius, more) =>
  outline({ x: turn.map(t => radius * Math.cos(t)), y: turn.map(t => radius * Math.sin(t)), ...more });
export const degrees = {
  label: 'θ from the direction of travel',
  symbol: 'θ =',
  unit: '°',
  digits: '.4g',
  ticks: [0, 90, 180, 270, 360],
  range: [0, 360]
};
export const travel = (x, y, size) => [
  arrows({ x: [x], y: [y], u: [size], v: [0], colour: 'ink' }),
  note({ x: x + 1.18 * size, y, text: 'v' })
];
const sense_of = ({ words }) => (words.sketch.clockwise ? -1 : 1);
const angles = Array.from({ length: 181 }, (_, i) => 2 * i);

/**
 * Returns curves of the load over its mean, { name, colour, dash, theta, load }, with at most `most` harmonics; the
 * last curve has all harmonics. If the study was solved with fewer harmonics, their load `cut` is used.
 */
function curves_of({ summary: { load }, tables }, most, least = 1) {
  const n = load.a.length - 1;
  const curve = ([name, colour, dash], series) => {
    const values = angles.map(angle => value_of(series, radians(angle)) / load.a[0]);
    return { name, colour, dash, theta: angles, load: values };
  };
  const some = load.cut
    ? [curve(look_of(`up_to_${load.cut.a.length - 1}`), load.cut)]
    : [1, 2, 3]
        .filter(k => k < n && k >= least && k <= most)
        .map(k => curve(look_of(`up_to_${k}`), truncated(load, k)));
  const all = curve([n === 1 ? 'first harmonic' : 'all harmonics', 'c1'], load);
  return [...some, { ...all, ...(tables.load_lines && columns(tables.load_lines)) }];
}

/** Shows the load round the rim from above, as a distance outwards from the rim. */
export function load_polar(doc) {
  const { summary } = doc;
  const load = pressing(doc);
  const sense = sense_of(doc);
  const at = (size, t) => [(1 + size / 2) * Math.cos(radians(t)), (1 + size / 2) * Math.sin(radians(t))];
  const parts = curves_of(doc, 3);
  const places_of = part => part.theta.map((theta, i) => at(part.load[i], theta));
  const all_places = parts.flatMap(places_of);
  const range = k => [
    Math.min(-1.6, ...all_places.map(p => p[k] - 0.1)),
    Math.max(1.6, ...all_places.map(p => p[k] + 0.1))
  ];
  const curve = part => {
    const places = places_of(part);
    const words = i => [part.name, `θ = ${shown(part.theta[i], '.4g')}°`, `λ/a_0 = ${shown(part.load[i], '.4g')}`];
    const extra = [
      { heading: 'θ (°)', values: part.theta },
      { heading: 'λ / R (N/m)', values: part.load.map(v => v * load.mean) }
    ];
    return { ...line({ ...part, x: places.map(p => p[0]), y: places.map(p => p[1]), words }), extra };
  };
  const loaded = parts[parts.length - 1];
  const lifted = loaded.load.some(v => v <= 0);
  const pressed = loaded.theta.map((theta, i) => (loaded.load[i] > 0 ? at(0, theta) : [NaN, NaN]));
  const arc = Array.from({ length: 13 }, (_, k) => sense * radians(sense * load.turn > 0 ? 200 + 4 * k : 250 - 4 * k));
  const sense_arrow = load.turn && summary.ring?.omega_terminal !== 0
    ? [
        line({ x: arc.map(a => 0.6 * Math.cos(a)), y: arc.map(a => 0.6 * Math.sin(a)), colour: 'c4' }),
        arrows({
          x: [0.6 * Math.cos(arc[11])],
          y: [0.6 * Math.sin(arc[11])],
          u: [0.6 * (Math.cos(arc[12]) - Math.cos(arc[11]))],
          v: [0.6 * (Math.sin(arc[12]) - Math.sin(arc[11]))],
          colour: 'c4',
          width: 2
        }),
        note({ x: 0.42 * Math.cos(radians(225)), y: 0.42 * sense * Math.sin(radians(225)), text: 'ω' })
      ].map(mark => ({ ...mark, near: () => null, value: undefined, count: 0, rows: () => [] }))
    : [];
  return {
    id: 'load',
    title: 'Load round the rim',
    equal: true,
    aspect: 0.85,
    words: `mean ${shown(load.mean, '.3g')} N/m, least ${shown(summary.load.least_load, '.3g')} N/rad, moment ratio ${shown(summary.load.moment_ratio, '.3g')}`,
    x: { range: range(0) },
    y: { range: range(1) },
    caption: `Seen from above and drawn outwards from the rim, the mean, ${shown(load.mean, '.3g')} N/m, as half a radius; v is the direction of travel, n the harmonics kept. A curve inside the rim is tensile (not physical).`,
    marks: [
      circle(1, { colour: 'c8', width: 1 }),
      line({
        x: pressed.map(p => p[0]),
        y: pressed.map(p => p[1]),
        colour: 'ink',
        width: 4,
        name: lifted ? 'under load' : '',
        words: i => [`θ = ${shown(loaded.theta[i], '.4g')}°`, 'under load']
      }),
      { ...circle(1.5, { colour: 'c8', width: 1 }), name: 'mean', dash: '2 3' },
      ...parts.map(curve),
      ...travel(0, 0, 0.4),
      strokes({ lines: [[0, 0, 0, 0.3 * sense]], colour: 'ink', dash: '6 4', heads: 1 }),
      note({ x: 0, y: 0.44 * sense, text: 'orbit’s centre' }),
      ...sense_arrow
    ]
  };
}

export function line_load(doc) {
  const { mean } = pressing(doc);
  const [left, right] = sense_of(doc) > 0 ? ['orbit’s centre', 'outside'] : ['outside', 'orbit’s centre'];
  const curve = part => line({ ...part, x: part.theta, y: part.load.map(v => v * mean) });
  return {
    id: 'line_load',
    title: 'Load per length of the rim',
    words: `${shown(mean, '.3g')} N/m on average`,
    caption: `λ(θ)/R: load per length of the rim at rest. At 90° lies ${left === 'outside' ? 'the outside' : 'the orbit’s centre'}, at 270° ${right === 'outside' ? 'the outside' : 'the orbit’s centre'}.`,
    x: degrees,
    y: { label: 'λ / R', unit: 'N/m', zero: true, digits: '.4g' },
    marks: [...curves_of(doc, 1).map(curve), rule({ y: mean, name: 'mean', dash: '2 3' })]
  };
}

export function higher_harmonics(doc) {
  const { load } = doc.summary;
  if (load.a.length < 3) return null;
  const first = truncated(load, 1);
  const beyond = part => part.load.map((v, i) => v - value_of(first, radians(part.theta[i])) / load.a[0]);
  const curve = part => line({ ...part, x: part.theta, y: beyond(part) });
  return {
    id: 'higher_harmonics',
    title: 'Load of the harmonics beyond the first',
    caption: 'Relative to its mean a_0; n harmonics kept.',
    x: degrees,
    y: { label: '(λ − λ_1) / a_0', zero: true, digits: '.3g' },
    marks: curves_of(doc, 3, 2).map(curve)
  };
}

/** Returns the harmonics of the load over its mean above rounding: { n, a, b, amplitude, band, resolved }. */
function harmonics_of({ summary: { load, error_bands } }) {
  const width = (k, n) => error_bands?.[k + n]?.band ?? 0;
  const rows = load.a.slice(1).map((_, i) => {
    const n = i + 1;
    const [a, b] = ['a', 'b'].map(key => load[key][n] / load.a[0]);
    return { n, a, b, amplitude: Math.hypot(a, b), band: Math.hypot(width('a', n), width('b', n)) };
  });
  // Harmonics without a band use the last available band.
  const last = rows.findLast(row => row.band > 0)?.band ?? 0;
  return rows
    .filter(row => row.amplitude > 1e-12)
    .map(row => ({ ...row, resolved: row.amplitude > (row.band || last) }));
}

/** Returns a table of those of the first eight harmonics that exceed their error band. */
export function table_of_harmonics(doc) {
  const rounded = value => (Math.abs(value) > 1e-12 ? value : 0);
  const rows = harmonics_of(doc).filter(row => row.n <= 8 && row.band <= row.amplitude);
  return table_of(
    ['n', 'a_n / a_0', 'b_n / a_0', 'amplitude / a_0', 'largest at θ (degrees)'],
    rows.map(({ n, a, b, amplitude }) => {
      const crest = (180 * Math.atan2(b, a)) / (Math.PI * n);
      return [n, rounded(a), rounded(b), amplitude, Math.round(10 * crest) / 10 + 0];
    })
  );
}

export function spectrum(doc) {
  const rows = harmonics_of(doc);
  if (rows.length < 2) return null;
  const part = (name, more, wanted) => {
    const picked = rows.filter(row => row.resolved === wanted);
    const values = key => picked.map(row => row[key]);
    return dots({
      name: picked.length ? name : '',
      x: values('n'),
      y: values('amplitude'),
      band: values('band'),
      ...more
    });
  };
  const has_hollow = rows.some(row => !row.resolved);
  const ticks = rows.map(row => row.n);
  const second = rows.find(row => row.n === 2)?.amplitude;
  return {
    id: 'spectrum',
    title: 'Harmonics of the load',
    words: second ? `the second is ${shown(second, '.2g')} of the mean` : '',
    caption:
      'Relative to its mean a_0. Values below 10⁻¹² are rounding and not shown.' +
      (has_hollow ? ' Hollow: smaller than the error band (or the last known band), not resolved.' : ''),
    x: {
      label: 'harmonic n',
      symbol: 'n =',
      range: [0.5, Math.max(1, ...ticks) + 0.5],
      ticks: ticks.length > 10 ? undefined : ticks
    },
    y: { label: '√(a_n² + b_n²) / a_0', log: true, digits: '.3g' },
    marks: [part('resolved', {}, true), part('not resolved', { hollow: true, colour: 'c8' }, false)]
  };
}

export function slip(doc, name, state) {
  if (!doc.tables[name]) return null;
  const t = columns(doc.tables[name]);
  const all = t.theta.map((_, i) => i);
  const said = i => [
    `θ = ${shown(t.theta[i], '.4g')}°`,
    `friction ${shown(Math.hypot(t.friction_x[i], t.friction_y[i]), '.3g')} of the mean load’s`,
    `slip ${shown(Math.hypot(t.slip_x[i], t.slip_y[i]), '.3g')} v`
  ];
  const part = (label, colour, scale, keys, picked, more) =>
    arrows({
      name: label,
      colour,
      x: picked.map(i => Math.cos(radians(t.theta[i]))),
      y: picked.map(i => Math.sin(radians(t.theta[i]))),
      u: picked.map(i => scale * t[keys[0]][i]),
      v: picked.map(i => scale * t[keys[1]][i]),
      words: picked.map(said),
      ...more
    });
  const friction = ['friction_x', 'friction_y'];
  const turning = (label, colour, has_sense) =>
    part(label, colour, 0.5, friction, all.filter(i => has_sense(t.torque[i])), { width: 2 });
  const ends = (key, around) => t[key].map((v, i) => around(radians(t.theta[i])) + 0.5 * v);
  const [ends_x, ends_y] = [ends('friction_x', Math.cos), ends('friction_y', Math.sin)];
  return {
    id: name,
    title: `Slip and friction round the rim ${state}`,
    equal: true,
    aspect: 0.82,
    x: { range: [Math.min(-1.5, ...ends_x) - 0.1, Math.max(1.5, ...ends_x) + 0.1] },
    y: { range: [Math.min(-1.2, ...ends_y) - 0.1, Math.max(1.62, ...ends_y) + 0.1] },
    words:
      name === 'slip_at_rest'
        ? `friction turns the glass with ${shown(doc.summary.ring.tau_at_rest, '.3g')} N m`
        : '',
    caption:
      'Seen from above. Grey: slip velocity of each point over the table. Coloured: friction on the point, by the sense of its torque. ' +
      'The difference between the two sides turns the glass; at the terminal spin the sides balance.',
    marks: [
      circle(1, { colour: 'c8', width: 1.4 }),
      part('slip', 'c8', 0.42, ['slip_x', 'slip_y'], all, { width: 1, head: 4 }),
      turning('turns clockwise', 'c1', torque => torque < 0),
      turning('turns counter-clockwise', 'c2', torque => torque >= 0),
      ...travel(-0.25, 1.62, 0.45)
    ]
  };
}
