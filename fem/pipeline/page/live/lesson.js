// The lesson: five steps from the hand to the terminal spin. Each asks for a prediction before it shows the answer.
import { $, doc, remember, sense, state, value_of } from './state.js';
import { h } from '../js/dom.js';
import { pressing } from '../js/series.js';
import { say, shown } from '../js/words.js';
import { lesson_texts } from './lesson_texts.js';
import { texts } from './texts.js';

const t = lesson_texts;
const chosen = {}; // predictions by step
const shown_parts = [['hand'], ['hand', 'pressure'], ['hand', 'pressure', 'friction'], ['hand', 'pressure', 'friction', 'torque'], ['hand', 'pressure', 'friction', 'torque']]; // prettier-ignore
const pictures = [[], ['load'], ['load'], ['torque'], ['spin', 'torque']];

/** Whether a part of the scene is shown in the present step. */
export const shows = part =>
  !state.lesson || shown_parts[state.lesson - 1].includes(part) || (chosen[state.lesson] !== undefined && shown_parts[Math.min(state.lesson, 4)].includes(part)); // prettier-ignore

const offset = () => value_of('Motion/Force offset');
/** The right prediction of each step, for the study as it is. */
const right = [
  () => (offset() < 0 ? 0 : offset() > 0 ? 1 : 2),
  () => 1,
  () => 1,
  () => (offset() * sense() < 0 ? 0 : offset() ? 1 : 2),
  () => 1
];

/** The numbers in the answer of each step. */
function numbers() {
  const { ring = {}, load = {}, paper = {} } = doc.summary;
  const at_rest = pressing(doc);
  const spin = ring.omega_terminal;
  return [
    [shown(1e3 * Math.abs(offset()), '.3g'), shown(1e3 * Math.abs(load?.moment?.[0] ?? NaN), '.3g')],
    [shown(at_rest.inside, '.3g'), shown(at_rest.outside, '.3g'), shown(load?.moment_ratio, '.2g')],
    [shown(Math.abs(doc.tables.motion?.[0].hand[0] ?? NaN), '.3g')],
    [shown(1e3 * ring.tau_at_rest, '.3g')],
    [shown(spin, '.3g'), shown((2 * Math.PI) / Math.abs(spin), '.3g'), shown(paper.omega_terminal, '.3g')]
  ];
}

/** Writes the present step; `changed` is called when what is shown changes. */
export function write_lesson(changed) {
  const step = state.lesson;
  $('lesson-button').textContent = step ? texts.all_of_it : texts.lesson;
  const go = to => {
    state.lesson = to;
    remember();
    write_lesson(changed);
    changed();
  };
  $('lesson-button').onclick = () => go(step ? 0 : 1);
  $('lesson').hidden = !step;
  if (step) document.body.dataset.lesson = step;
  else delete document.body.dataset.lesson;
  document.body.toggleAttribute('data-told', step === 5 && chosen[5] !== undefined);
  for (const place of document.querySelectorAll('[data-picture]'))
    place.closest('.card').classList.toggle('taught', step > 0 && pictures[step - 1].includes(place.dataset.picture));
  if (!step) return;
  const { title, question, options, answer, then } = t.steps[step - 1];
  const mine = chosen[step];
  const choose = i => {
    chosen[step] = i;
    write_lesson(changed);
    changed();
  };
  const predictions = options.map((text, i) =>
    h('button', { 'aria-pressed': String(mine === i), onclick: () => choose(i) }, say(text))
  );
  const said = mine === undefined ? [] : [h('p', {}, h('b', {}, mine === right[step - 1]() ? t.right : t.other), ' ', say(answer, ...numbers()[step - 1])), h('p', {}, say(then))]; // prettier-ignore
  $('lesson').replaceChildren(
    h('h2', {}, say(t.step, step, title)),
    h('p', {}, say(question)),
    h('p', { class: 'row', role: 'group', 'aria-label': question }, predictions),
    ...said,
    h('p', { class: 'row' }, step > 1 && h('button', { onclick: () => go(step - 1) }, t.back), step < 5 && h('button', { disabled: mine === undefined, onclick: () => go(step + 1) }, t.next)) // prettier-ignore
  );
}
