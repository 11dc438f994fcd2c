// The live page: it solves the study again at every move of a slider.
import { $, all_harmonics, data, digits, doc, errors, forget, found, learn, pair, recall, remember, state } from './state.js';
import { Queue, start_solver } from './solver.js';
import { calm, picture } from './pictures.js';
import { chosen, make_choices, make_sliders, write_harmonics } from './controls.js';
import { download, h } from '../js/dom.js';
import { draw_scene, make_scene } from './turning.js';
import { make_measured } from './measured.js';
import { page_with_state, save_curves, study_text } from './keep.js';
import { print_sheet } from './sheet.js';
import { facts, tell, tell_late } from './says.js';
import { figure_of, show_anew } from '../js/sections.js';
import { say } from '../js/words.js';
import { texts } from './texts.js';
import { write_lesson } from './lesson.js';

const opened = performance.now();
const page = document.documentElement.outerHTML; // original page
let stands = {}; // changes in the last state in which the glass did not tip
addEventListener('error', e => errors.push(e.message));
addEventListener('unhandledrejection', e => errors.push(String(e.reason)));

const drawn = new Map(); // current pictures, by name
const places = [...document.querySelectorAll('[data-picture]')];

function draw_picture(place) {
  const name = place.dataset.picture;
  const shown = found.answer && picture(name);
  if (!shown) {
    drawn.delete(name);
    place.replaceChildren(h('p', { class: 'soft' }, document.body.dataset.rested ? texts.nothing : texts.budget_wait));
    return;
  }
  drawn.set(name, shown);
  if (!show_anew(shown) || !place.querySelector('figure')) place.replaceChildren(figure_of(shown));
}
const draw = wanted => places.filter(place => wanted.includes(place.dataset.picture)).forEach(draw_picture);

let late = 0; // timer of a request without an answer
const first_words = 350; // ms until the page shows intermediate results
function show(reply, ms, is_last) {
  clearTimeout(late);
  late = 0;
  document.body.classList.toggle('busy', !is_last);
  Object.assign(found, { answer: reply, is_last, has_curves: false });
  if (reply.document) learn(reply.document);
  else forget();
  if (is_last && Number.isFinite(doc.summary.ring?.omega_terminal)) stands = { ...state.changes };
  tell(ms);
  draw(['load']);
  draw_scene();
  write_lesson(draw_scene);
  // Curves, budget and pressure are slow. They are updated only when no control moves.
  if (!reply.document || reply.was_cold) draw(calm);
}

function draw_curves() {
  found.has_curves = true;
  draw_scene();
  write_lesson(draw_scene);
}

const queue = new Queue({
  show,
  late: ms => show({ error: texts.too_close }, ms, true),
  use: (name, reply) => {
    learn(reply.document);
    draw(name === 'curves' ? ['torque', 'spin'] : [name]);
    if (name === 'curves') draw_curves();
    if (name === 'budget') facts(queue.times[queue.times.length - 1]);
  },
  rest: () => {
    if (!found.has_curves) draw_curves(); // if no curves were computed in time, the scene shows one instant
    draw(calm.filter(name => !drawn.has(name)));
  }
});
function solve(cold) {
  document.body.classList.add('busy');
  delete document.body.dataset.rested;
  late ||= setTimeout(tell_late, first_words);
  queue.solve(cold);
}

function solve_hand(cold) {
  make_sliders(solve);
  solve(cold);
}

function choose() {
  forget();
  chosen(solve);
  write_harmonics();
  remember();
  solve(true);
}

/** Shows only the answer of `stemware run`, if the solver has failed. */
function lost(error) {
  const why = String(error.message || error).slice(0, 100);
  errors.push(why);
  $('answer').textContent = say(texts.lost, why, state.glass, state.table, digits(pair().omega));
}

document.querySelector('main').remove(); // text for browsers without scripts
recall();
make_choices(choose);
$('live').hidden = false;
make_scene(solve_hand, () => {
  state.changes = { ...stands };
  choose();
});
write_lesson(draw_scene);
chosen(solve);
write_harmonics();
tell_late();
$('harmonics').oninput = () => {
  state.harmonics = Number($('harmonics').value);
  write_harmonics();
  remember();
  solve(false);
};
$('reset').onclick = () => {
  Object.assign(state, { changes: {}, unknown: [], harmonics: all_harmonics });
  choose();
};
$('as-prm').onclick = () => download('explored.prm', study_text(), 'text/plain');
$('as-csv').onclick = () => save_curves(drawn.values());
$('as-page').onclick = () => download('explored.html', page_with_state(page), 'text/html');
$('as-sheet').onclick = print_sheet;
addEventListener('beforeprint', () => ($('more').open = true));
$('as-print').onclick = () => print();
make_measured(() => draw(['spin']));
addEventListener('hashchange', () => {
  state.changes = {};
  state.lesson = 0;
  recall();
  choose();
});
document.body.dataset.complete = String(Math.round(performance.now()));
// Interface for tests: changes an entry and waits for the answer of the last request.
window.move = (path, value) =>
  new Promise(done => {
    if (value === undefined) delete state.changes[path];
    else state.changes[path] = String(value);
    make_sliders(solve);
    remember();
    solve(true);
    const wait = () => {
      if (!queue.rests) return setTimeout(wait, 10);
      done({
        omega: doc.summary.ring?.omega_terminal ?? null,
        error: found.answer.error || '',
        errors,
        text: $('answer').textContent
      });
    };
    wait();
  });
start_solver(data)
  .then(() => {
    window.started = { ready: performance.now() - opened };
    queue.begin();
  })
  .catch(lost);
