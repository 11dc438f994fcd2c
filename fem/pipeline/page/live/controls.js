// Controls of the study: glasses, tables, sliders and the number of harmonics.
import { $, acts, all_harmonics, base_value, data, drop_changes, is_changed, load_entries, radius, remember, similar, state, value_of } from './state.js';
import { h } from '../js/dom.js';
import { say, shown } from '../js/words.js';
import { texts } from './texts.js';

// Sliders: entry, minimum, maximum, step, displayed unit, displayed over SI value, logarithmic scale.
const first = [
  ['Motion/Hand height', 5, 150, 1, 'mm', 1000],
  ['Motion/Orbit speed', 0.05, 0.6, 0.01, 'm/s', 1],
  ['Motion/Friction coefficient', 0.05, 0.6, 0.01, '', 1]
];
const further = [
  ['Motion/Orbit radius', 5, 40, 0.5, 'cm', 100],
  ['Glass/Contact radius', 24, 36, 3, 'mm', 1000],
  ['Motion/Mass', 100, 800, 10, 'g', 1000],
  ['Motion/Centre of mass height', 30, 150, 1, 'mm', 1000],
  ['Motion/Grip torque', 0, 3, 0.05, 'mN m', 1000],
  ['Glass/Crown radius', 1, 12, 0.1, 'mm', 1000],
  ['Table/Foundation modulus', 8, 11.5, 0.05, 'Pa/m', 1, true],
  ['Table/Disc Young modulus', 6, 11.5, 0.05, 'Pa', 1, true],
  ['Table/Decay length', -7, -5, 0.05, 'm', 1, true]
];

function slider([path, from, to, step, unit, factor, log], solve) {
  const id = path.replace(/\W/g, '-');
  const place_of = value => (log ? Math.log10(value) : value * factor);
  const base = place_of(base_value(path));
  const output = h('output', { for: id });
  const range = { type: 'range', id, step, min: Math.min(from, base), max: Math.max(to, base) };
  const input = h('input', { ...range, value: place_of(value_of(path)) });
  const node = h('div', { class: 'slider' });
  const write = () => {
    const value = value_of(path);
    output.textContent =
      (log ? shown(value, '.2e') : shown(Number((value * factor).toFixed(3)), '.9g')) + (unit && ` ${unit}`);
    if (path === radius) output.textContent += say(texts.similar, shown(1e3 * similar(value_of('Glass/Foot thickness')), '.2g'));
    input.setAttribute('aria-valuetext', output.textContent);
    node.classList.toggle('changed', is_changed(path));
  };
  const moved = () => {
    write();
    remember();
    solve(false);
  };
  input.addEventListener('input', () => {
    const raw = Number(input.value);
    const near = log ? 1e-9 : step / 2;
    if (Math.abs(raw - base) < near) delete state.changes[path];
    else state.changes[path] = String(Number((log ? 10 ** raw : raw / factor).toPrecision(6)));
    moved();
  });
  const back = () => {
    delete state.changes[path];
    input.value = base;
    moved();
  };
  const label = h('label', { for: id, ondblclick: back }, texts.labels[path] || path.split('/')[1]);
  node.append(label, output, input);
  write();
  return node;
}

export function make_sliders(solve) {
  $('thickness').textContent = acts(radius) && base_value('Glass/Foot thickness') === 0.004 ? say(texts.thickness) : '';
  for (const [box, list] of [
    ['sliders', first],
    ['more-sliders', further]
  ])
    $(box).replaceChildren(
      ...list.filter(([path]) => acts(path)).map(entry => slider(entry, solve))
    );
}

export function write_harmonics() {
  const text = state.harmonics >= all_harmonics ? texts.all : say(texts.first, state.harmonics);
  $('harmonics-out').textContent = text;
  $('harmonics').setAttribute('aria-valuetext', text);
  $('harmonics').value = state.harmonics;
}

const kinds = { glasses: 'glass', tables: 'table' };

export function chosen(solve) {
  for (const [box, kind] of Object.entries(kinds))
    for (const button of $(box).children) button.setAttribute('aria-pressed', button.dataset.name === state[kind]);
  load_entries();
  make_sliders(solve);
}

/** Makes the buttons of glasses and tables, which call `choose`. */
export function make_choices(choose) {
  for (const [box, kind] of Object.entries(kinds))
    for (const { name, words: title } of data[box]) {
      const take = () => {
        if (state[kind] === name) return;
        drop_changes(data[box], state[kind], name);
        state[kind] = name;
        choose();
      };
      const pressed = String(state[kind] === name);
      $(box).append(h('button', { 'aria-pressed': pressed, 'data-name': name, title, onclick: take }, name));
    }
}
