// The class sheet of the lesson, as in docs/lesson_class.md: a printed page of this file.
import { $ } from './state.js';
import { h } from '../js/dom.js';

const runs = ['quantity', 'run 1', 'run 2', 'run 3'];
const parts = [
  ['Predict, before you try', 'Write down what you expect, and one sentence why.', ['question', 'I expect', 'because', 'I saw']],
  [
    '1. The orbit is counter-clockwise, seen from above, and the hand is low on the stem. Which way does the glass spin?',
    '2. The hand is as high as the centre of mass of the glass. Does the glass spin?',
    '3. The hand is higher than the centre of mass. Which way does the glass spin?',
    '4. The speed is halved on the same circle. How much of the spin is left?',
    '5. The table has half the friction. How does the spin change?',
    '6. A glass of the same shape has twice the mass. How does the spin change?'
  ],
  ['Measure', 'Film from above. Count the turns of a dot on the foot relative to the room. Change one thing between runs.', runs],
  [
    'mass (g)',
    'radius of the foot’s ring (mm)',
    'height of the centre of mass (mm)',
    'height of the hand above the table (mm)',
    'radius ρ of the circle (cm)',
    'time of ten rounds (s), and v = 20 π ρ / time',
    'time of ten turns of the glass (s), and ω = 20 π / time',
    'ω of this page with these values'
  ],
  ['Explain', 'Use the lesson of the page after you have thought.', ['question', 'I think']],
  [
    'The hand pulls towards the centre of the circle. Which side of the foot is pressed harder when the hand is low, and why?',
    'Friction acts on each piece of a rim that does not spin yet. Sketch the arrows: what is their sum, and their torque about the axis?',
    'Let the glass spin a little. How do the arrows turn, and why does this brake the spin?',
    'Which measured quantity changes the result most if it is slightly wrong? What is the effect of fingers that hold the stem?'
  ]
];
const row = (tag, cells) => h('tr', {}, cells.map(text => h(tag, {}, text)));

export function print_sheet() {
  const filled = parts.flatMap((part, i) => {
    if (i % 2) return [];
    const [title, text, head] = part;
    const lines = parts[i + 1].map(question => row('td', head.map((_, k) => (k ? '' : question))));
    return [h('h2', {}, title), h('p', {}, text), h('table', {}, h('thead', {}, row('th', head)), h('tbody', {}, lines))];
  });
  $('sheet').replaceChildren(h('h1', {}, document.title), ...filled);
  $('sheet').hidden = false;
  document.body.dataset.sheet = '';
  print();
  delete document.body.dataset.sheet;
  $('sheet').hidden = true;
}
