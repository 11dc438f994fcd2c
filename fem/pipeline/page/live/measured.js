// A measured run: read, drawn and fitted by the solver, while the page stays as it is.
import { $, doc, pair_name, state } from './state.js';
import { curve, ellipse } from '../views/fit.js';
import { figure_of, show_anew } from '../js/sections.js';
import { h } from '../js/dom.js';
import { on_page } from './pictures.js';
import { say, shown } from '../js/words.js';
import { texts } from './texts.js';

const offered = ['Motion/Friction coefficient', 'Motion/Grip torque', 'Motion/Centre of mass height'];
const free = new Set(offered.slice(0, 2));
let queue, run; // { name, text } of the file
let is_start_free = true,
  held_start = 0; // s
let fitted = null; // document of the last fit, with `reads`: what was read

const label = path => texts.labels[path] || path.split('/')[1];
const status = text => ($('fit-status').textContent = text);

/** Files of this size are no runs of a glass; the whole text goes to the solver. */
const largest = 2e7;

async function take(file, draw_spin) {
  if (!file) return;
  if (file.size > largest) return status(texts.fit_large);
  run = { name: file.name, text: (await file.text()).replaceAll('\0', ' ') };
  fitted = null;
  write_measured();
  const asked = await queue.wait_for({ do: 'measured', pair: pair_name(), changes: { ...state.changes }, ...run });
  if (!asked) return status(texts.fit_cancelled);
  if (asked.reply.error) {
    run = null;
    delete doc.tables.measured;
    write_measured();
    status(asked.reply.error);
  } else {
    doc.tables.measured = asked.reply.document.tables.measured;
    const text = `${run.name}: ${asked.reply.document.words.data}`;
    status(text);
  }
  draw_spin();
}

async function fit() {
  const start = is_start_free ? '' : String(held_start);
  const message = { do: 'fit', pair: pair_name(), changes: { ...state.changes }, ...run, free: [...free].join('\n'), start };
  status(texts.fitting);
  $('fit').hidden = true;
  $('fit-cancel').hidden = false;
  const asked = await queue.wait_for(message);
  $('fit-cancel').hidden = true;
  $('fit').hidden = false;
  fitted = asked?.reply.document || null;
  write_measured();
  if (!asked) status(texts.fit_cancelled);
  else if (asked.reply.error) status(asked.reply.error);
  else status(say(texts.fit_done, (asked.ms / 1000).toFixed(1)));
}

function value_of({ value, spread, unit }) {
  const own = unit === '1' ? '' : ` ${unit}`;
  return `${shown(value, '.5g')} ± ${shown(spread, '.2g')}${own}`;
}

/** Values, curve, ellipses and sentences of the fit. */
function result() {
  const { entries, runs } = fitted.summary.fit;
  const rows = [
    ...entries.map(entry => [label(entry.entry), value_of(entry)]),
    [texts.fit_start, value_of({ value: runs[0].start, spread: runs[0].start_spread, unit: 's' })]
  ];
  const pictures = [on_page(curve(fitted, runs[0], 0), 'live_fit', texts.fit_curve)];
  entries.forEach((_, j) => {
    for (let i = 0; i < j; ++i) {
      const given = ellipse(fitted, i, j, label);
      pictures.push(on_page(given, `live_${given.id}`, texts.fit_ellipse));
    }
  });
  pictures.forEach(show_anew);
  return [
    h('dl', { class: 'fitted' }, rows.map(([name, value]) => h('div', {}, h('dt', {}, name), h('dd', {}, value)))), // prettier-ignore
    fitted.words.fit_sentences.map(({ key, text, values }) => {
      const own = texts.fit_sentences[key];
      const named = values.map(value => (offered.includes(value) ? label(value) : value));
      return h('p', {}, own ? say(own, ...named) : text);
    }),
    h('div', { class: 'figures' }, pictures.map(figure_of))
  ];
}

/** Frees the start, or holds it where the last fit has it. */
function hold(e) {
  is_start_free = e.target.checked;
  if (fitted) held_start = Number(fitted.summary.fit.runs[0].start.toPrecision(4));
  write_measured();
}

/** Writes the card. */
export function write_measured() {
  $('fit-free').replaceChildren(
    ...offered.map(path => {
      const change = e => {
        free[e.target.checked ? 'add' : 'delete'](path);
        $('fit').disabled = !run || !free.size;
      };
      const box = h('input', { type: 'checkbox', checked: free.has(path), onchange: change });
      return h('label', { class: 'choice' }, box, ' ', label(path));
    }),
    h('label', { class: 'choice' }, h('input', { id: 'fit-start-free', type: 'checkbox', checked: is_start_free, onchange: hold }), ' ', texts.fit_start), // prettier-ignore
    is_start_free ? '' : h('label', { class: 'choice' }, texts.fit_held, ' ', h('input', { id: 'fit-start', type: 'number', step: 'any', value: held_start, onchange: e => (held_start = e.target.valueAsNumber || 0) })) // prettier-ignore
  );
  $('fit').disabled = !run || !free.size;
  $('fit-result').replaceChildren(...(fitted ? result() : []).flat());
}

/** The card of measured runs; `draw_spin` draws the spin-up anew. */
export function make_measured(given, draw_spin) {
  queue = given;
  write_measured();
  status(texts.fit_wait);
  $('measured').onchange = e => take(e.target.files[0], draw_spin);
  $('fit').onclick = fit;
  $('fit-cancel').onclick = () => queue.cancel();
  addEventListener('dragover', e => e.preventDefault());
  addEventListener('drop', e => {
    e.preventDefault();
    take(e.dataTransfer.files[0], draw_spin);
  });
}
