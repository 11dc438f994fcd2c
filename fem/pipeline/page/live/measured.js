// Measured run shown with the computed spin-up: a table whose first numeric column is time.
import { $, doc } from './state.js';
import { say, shown } from '../js/words.js';
import { h } from '../js/dom.js';
import { columns, table_of } from '../js/tables.js';
import { texts } from './texts.js';

const degree = Math.PI / 180;
const units = { 'rad/s': [1, false], '°/s': [degree, false], rad: [1, true], '°': [degree, true] }; // factor, is an angle
const separators = ['\t', ';', /\s+/, /,(?=(?:[^"]*"[^"]*")*[^"]*$)/];
const max_bytes = 2e7;
const max_points = 200; // more points would hide the curve
let run = { time: null, columns: [] }; // columns: { heading, values }

const bare = cell => cell.trim().replace(/^"(.*)"$/, '$1');
/** Returns the number in a cell, with decimal comma or point; NaN for other text. */
function number(cell) {
  const text = bare(cell).replace('−', '-');
  return /^[-+]?(\d+([.,]\d*)?|[.,]\d+)(e[-+]?\d+)?$/i.test(text) ? Number(text.replace(',', '.')) : NaN;
}
const is_data = row => row.filter(Number.isFinite).length > 1;

function read(text) {
  const lines = text.split(/[\r\n]+/).filter(line => line.trim());
  const sample = lines[lines.length >> 1] || '';
  const separator = separators.find(one => is_data(sample.trim().split(one).map(number)));
  const cells = lines.map(line => line.trim().split(separator));
  const rows = cells.map(row => row.map(number));
  const [first, data] = [rows.findIndex(is_data), rows.filter(is_data)];
  if (first < 0) return [];
  const headings = cells[first - 1]?.length === data[0].length ? cells[first - 1].map(bare) : [];
  const columns = data[0].map((_, i) => ({
    heading: headings[i] || say(texts.column, i + 1),
    values: data.map(row => row[i] ?? NaN)
  }));
  return columns.filter(({ values }) => 2 * values.filter(Number.isFinite).length > values.length);
}

function range({ values }) {
  const known = values.filter(Number.isFinite);
  return known.reduce((a, b) => Math.max(a, b)) - known.reduce((a, b) => Math.min(a, b));
}

/** Adds the chosen column to the document, as spins [rad/s] over time [s]. Angles are differentiated. */
function convert() {
  const { values } = run.columns[$('measured-column').value];
  const [factor, is_angle] = units[$('measured-unit').value];
  const rate = i => (values[i + 1] - values[i - 1]) / (run.time[i + 1] - run.time[i - 1]);
  const [from, to] = ['from', 'to'].map(end => Number($(`measured-${end}`).value));
  const points = run.time.map((t, i) => [t - from, factor * (is_angle ? rate(i) : values[i])]);
  const end = Math.min(to - from, doc.tables.spin_up ? Math.max(...columns(doc.tables.spin_up).time) : Infinity); // end of the computed curve
  const kept = points.filter(point => point[0] >= 0 && point[0] <= end && point.every(Number.isFinite));
  const step = Math.ceil(kept.length / max_points);
  for (const end of ['from', 'to']) $(`measured-${end}-out`).textContent = `${shown(Number($(`measured-${end}`).value), '.2f')} s`;
  doc.tables.measured = table_of(['time', 'omega'], kept.filter((_, i) => i % step === 0));
}

/** Makes the controls of a measured run. `draw` redraws the spin-up. */
export function make_measured(draw) {
  const take = async file => {
    if (!file) return;
    const [time, ...columns] = file.size > max_bytes ? [] : read(await file.text());
    run = { time: time?.values, columns: columns.sort((a, b) => range(b) - range(a)) };
    $('measured-column').replaceChildren(...run.columns.map(({ heading }, i) => h('option', { value: i }, heading)));
    $('measured-choice').hidden = !run.columns.length;
    delete doc.tables.measured;
    const known = (run.time || []).filter(Number.isFinite);
    const [min, max] = [known[0], known[known.length - 1]];
    for (const [end, value] of [['from', min], ['to', max]]) Object.assign($(`measured-${end}`), { min, max, value });
    if (run.columns.length) convert();
    const text = run.columns.length ? texts.measured : texts.unreadable;
    $('measured-status').textContent = say(text, file.name, run.time?.length, shown(range({ values: run.time || [0] }), '.3g'));
    draw();
  };
  $('measured').onchange = e => take(e.target.files[0]);
  const anew = () => (convert(), draw());
  for (const id of ['column', 'unit', 'from', 'to']) Object.assign($(`measured-${id}`), { oninput: anew, onchange: anew });
  addEventListener('dragover', e => e.preventDefault());
  addEventListener('drop', e => (e.preventDefault(), take(e.dataTransfer.files[0])));
}
