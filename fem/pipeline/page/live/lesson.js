// Lesson in five steps, from the hand to the terminal spin. Each step asks for a prediction before its
// answer.
import { $, at_end, centre, digits, doc, fall, found, hand_offset, is_held, remember, sense, state, value_of } from './state.js';
import { h } from '../js/dom.js';
import { pressing } from '../js/series.js';
import { say, shown } from '../js/words.js';
import { lesson_texts } from './lesson_texts.js';
import { failure_text, seconds_of } from './says.js';
import { texts } from './texts.js';

const t = lesson_texts;
const chosen = {}; // predictions by step
// Number of scene parts that each step shows before and after the prediction.
const scene_parts = ['hand', 'pressure', 'friction', 'torque'];
const parts_before = [1, 1, 2, 3, 4];
const parts_after = [2, 2, 3, 4, 4];
const pictures_before = [[], [], ['load'], [], ['torque']];
const pictures_after = [[], ['load'], ['load'], ['torque'], ['spin', 'torque']];
const is_predicted = () => chosen[state.lesson] !== undefined;
const at_step = (before, after) => (is_predicted() ? after : before)[state.lesson - 1];

export const shows = part => !state.lesson || scene_parts.indexOf(part) < at_step(parts_before, parts_after);

/** Returns the side with the larger load at rest: 0 outside, 1 inside, 2 equal. */
const side = () => ['outside', 'inside', 'even'].indexOf(pressing(doc).harder);
/**
 * Returns the direction of the torque at rest: 0 against the orbit, 1 with the orbit, 2 no torque. If no torque was
 * computed, the side with the larger load determines the direction.
 */
function way() {
  const torque = doc.summary.ring.tau_at_rest;
  return !Number.isFinite(torque) ? side() : torque === 0 ? 2 : torque * sense() < 0 ? 0 : 1;
}
const right = [side, () => (doc.summary.load?.moment_ratio > 1 ? 2 : 1), () => 1, way, () => 1];

const answers = [
  ({ answer }) => {
    const millimetres = 1e3 * Math.abs(hand_offset());
    const moment = 1e3 * Math.abs(doc.summary.load?.moment?.[0]);
    return say(answer[side()], shown(millimetres, '.3g'), shown(moment, '.3g'));
  },
  ({ answer }) => {
    const { inside, outside } = pressing(doc);
    return say(
      answer[right[1]()],
      ...[inside, outside].map(x => shown(x, '.3g')),
      shown(doc.summary.load?.moment_ratio, '.2g')
    );
  },
  ({ answer }) => say(answer[way() === 2 ? 2 : 1], shown(Math.abs(doc.tables.motion?.[0].hand[0] ?? NaN), '#.3g')),
  ({ answer }) => say(answer[way()], digits(1e3 * doc.summary.ring.tau_at_rest)),
  ({ answer, paper: beside, ...states }) => {
    const { ring, paper } = doc.summary;
    const { omega_terminal: omega, fall: fallen } = ring;
    if (fallen) return say(states.falls, digits(fallen.omega));
    if (way() === 2) return states.still;
    if (is_held()) return states.held;
    const compared = Number.isFinite(paper?.omega_terminal) ? ' ' + say(beside, digits(paper.omega_terminal)) : '';
    return say(answer, digits(omega), seconds_of(omega)) + compared;
  }
];

const thens = {
  2: ({ then, also }) => {
    const { a, b } = at_end().summary.load;
    return say(then, way() === 2 ? '' : also, shown((100 * Math.hypot(a[2], b[2])) / a[0], '.2g'));
  },
  4: ({ then, none }) => (way() === 2 || is_held() ? none : then),
  5: ({ then, too_high, gripped }) => {
    const { highest } = fall();
    if (is_held()) return gripped;
    return hand_offset() < 0 && highest < value_of(centre) ? say(too_high, shown(1e3 * highest, '.2g')) : then;
  }
};

/** Returns the verdict on a prediction. "The net force" (option 0) of step 3 is half right if there is a torque. */
function verdict(step, mine) {
  if (mine === right[step - 1]()) return t.right;
  return step === 3 && mine === 0 && way() !== 2 ? t.half : t.other;
}

const buttons = () => [...$('lesson').querySelectorAll('button')];

/** Writes the current step; `changed` is called after a change of step or prediction. */
export function write_lesson(changed) {
  const step = state.lesson;
  $('lesson-button').textContent = step ? texts.all_of_it : texts.lesson;
  const go = to => {
    state.lesson = to;
    remember();
    write_lesson(changed);
    changed();
    if (to) buttons()[0].focus();
  };
  $('lesson-button').onclick = () => go(step ? 0 : 1);
  $('lesson').hidden = !step;
  if (step) document.body.dataset.lesson = step;
  else delete document.body.dataset.lesson;
  document.body.toggleAttribute('data-told', step === 5 && chosen[5] !== undefined);
  for (const place of document.querySelectorAll('[data-picture]'))
    place.closest('.card').classList.toggle('taught', step > 0 && Boolean(doc.summary.ring) && at_step(pictures_before, pictures_after).includes(place.dataset.picture));
  if (!step) return;
  const words = t.steps[step - 1];
  const { title, question, options } = words;
  const mine = chosen[step];
  const choose = i => {
    chosen[step] = i;
    write_lesson(changed);
    changed();
  };
  const predictions = options.map((text, i) =>
    h('button', { 'aria-pressed': String(mine === i), onclick: () => choose(i) }, say(text))
  );
  const said = [];
  const { answer } = found;
  if (answer?.error) said.push(h('p', {}, answer.tips ? t.tips : failure_text(answer)));
  else if (doc.summary.ring && mine !== undefined)
    said.push(
      h('p', {}, h('b', {}, verdict(step, mine)), ' ', answers[step - 1](words)),
      h('p', {}, thens[step]?.(words) ?? words.then)
    );
  const focused = buttons().indexOf(document.activeElement);
  $('lesson').replaceChildren(
    h('h2', {}, say(t.step, step, title)),
    h('p', {}, say(question)),
    h('p', { class: 'row', role: 'group', 'aria-label': question }, predictions),
    ...said,
    h('p', { class: 'row' }, step > 1 && h('button', { onclick: () => go(step - 1) }, t.back), step < 5 && h('button', { disabled: mine === undefined, onclick: () => go(step + 1) }, t.next))
  );
  buttons()[focused]?.focus();
}
