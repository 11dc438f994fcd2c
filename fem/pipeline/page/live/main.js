// The page that solves again at every move of a slider.
import { $, all_harmonics, data, digits, errors, forget, found, local, pair, recall, remember, say, speak, spoken, state, words } from './state.js'; // prettier-ignore
import { Queue, start_solver } from './solver.js';
import { calm, pictures } from './pictures.js';
import { chosen, make_choices, make_sliders, write_harmonics } from './controls.js';
import { download, h } from '../js/dom.js';
import { draw_scene, start_scene } from './scene.js';
import { read_measured, save_curves, study_text } from './keep.js';
import { facts, tell } from './says.js';
import { figure_of, show_anew } from '../js/sections.js';
import { sentences } from './sentences.js';
import { side } from './side.js';

const opened = performance.now();
addEventListener('error', e => errors.push(e.message));
addEventListener('unhandledrejection', e => errors.push(String(e.reason)));

const all_pictures = { ...pictures, side };
const drawn = new Map(); // what the pictures show, by their places
const places = [...document.querySelectorAll('[data-picture]')];

function draw_picture(place) {
  const name = place.dataset.picture;
  const given = found.answer && all_pictures[name]();
  if (!given) {
    drawn.delete(name);
    const text = queue.rests && found.answer && !found.answer.all ? words().nothing : words().budget_wait;
    place.replaceChildren(h('p', { class: 'soft' }, text));
    return;
  }
  const picture = { caption: '', ...given, id: name, title: words()[name], marks: given.marks.filter(Boolean) };
  drawn.set(name, picture);
  if (!show_anew(picture) || !place.querySelector('figure')) place.replaceChildren(figure_of(picture));
}
const draw = names => places.filter(place => names.includes(place.dataset.picture)).forEach(draw_picture);

function show(reply, ms, is_last) {
  document.body.classList.toggle('busy', !is_last);
  found.answer = reply.error && !reply.all ? { ...reply, all: null } : reply;
  if (!found.answer.all) forget();
  tell(ms);
  draw(['load', 'side']);
  draw_scene();
  // Curves, budget and pressure stay those of the last pause while something moves.
  if (!found.answer.all || reply.was_cold) draw(calm);
}

const queue = new Queue({
  show,
  slow: () => ($('notice').textContent = words().solving),
  use: (name, reply) => {
    found[name] = reply;
    draw(name === 'curves' ? ['torque', 'spin'] : [name]);
    if (name === 'budget') facts(queue.times[queue.times.length - 1]);
  }
});
function solve(cold) {
  if (queue.busy) document.body.classList.add('busy');
  queue.solve(cold);
}

function choose() {
  forget();
  chosen(solve);
  write_harmonics();
  remember();
  solve(true);
}

/** Without a solver the page has the answer of `stemware run` alone. */
function lost(error) {
  const why = String(error.message || error).slice(0, 100);
  errors.push(why);
  $('answer').textContent = local(say(words().lost, why, state.glass, state.table, digits(pair().omega)));
}

function write_words() {
  document.documentElement.lang = state.language;
  document.title = words().title;
  for (const node of document.querySelectorAll('[data-t]')) node.textContent = words()[node.dataset.t];
  document.querySelector('main').hidden = false;
  const button = code => {
    const take = () => {
      speak(code);
      remember();
      write_words();
      make_sliders(solve);
      if (found.answer) tell(queue.times[queue.times.length - 1] || 0);
      draw(Object.keys(all_pictures));
      draw_scene();
    };
    const pressed = String(code === state.language);
    return h('button', { lang: code, 'aria-pressed': pressed, onclick: take }, sentences[code].name);
  };
  $('languages').replaceChildren(...Object.keys(sentences).map(button));
  write_harmonics();
}

async function take_file(file) {
  if (!file) return;
  const measured = read_measured(await file.text());
  if (!measured) $('notice').textContent = words().drop;
  else {
    found.measured = measured;
    draw(['spin']);
  }
}

async function copy_address() {
  try {
    await navigator.clipboard.writeText(location.href);
    $('as-link').textContent = words().copied;
    setTimeout(() => ($('as-link').textContent = words().as_link), 1500);
  } catch {
    prompt('', location.href);
  }
}

speak(spoken());
recall();
make_choices(choose);
write_words();
chosen(solve);
draw_scene();
start_scene();
$('answer').textContent = words().start;
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
$('as-link').onclick = copy_address;
$('as-print').onclick = () => print();
$('measured').onchange = e => take_file(e.target.files[0]);
addEventListener('dragover', e => e.preventDefault());
addEventListener('drop', e => {
  e.preventDefault();
  take_file(e.dataTransfer.files[0]);
});
addEventListener('hashchange', () => {
  state.changes = {};
  recall();
  write_words();
  choose();
});
// What a test asks: moves an entry, and waits for the answer of the last wish.
window.move = (path, value) =>
  new Promise(done => {
    if (value === undefined) delete state.changes[path];
    else state.changes[path] = String(value);
    make_sliders(solve);
    remember();
    solve(true);
    const wait = () => {
      const { answer } = found;
      if (!queue.rests) return setTimeout(wait, 10);
      done({ omega: answer.all?.omega ?? null, error: answer.error || '', errors, text: $('answer').textContent });
    };
    wait();
  });
start_solver(data)
  .then(() => {
    window.started = { ready: performance.now() - opened };
    queue.begin();
  })
  .catch(lost);
