// Animated scene of the spin-up: the glass in perspective with the pressure round its rim, friction, the hand
// and the net torque, in slow motion. Every instant is a row of the document.
import { Drawing, height, width } from './drawing.js';
import { copy_of } from './files.js';
import { follow } from './pointer.js';
import { h } from './dom.js';
import { is_tumbler } from './space.js';
import { shown } from './words.js';
import { texts } from '../live/texts.js';

const t = texts.scene_words;
const slower = 10;

function between(rows, time) {
  const i = rows.findIndex(row => row.time >= time);
  if (i <= 0) return rows[i < 0 ? rows.length - 1 : 0];
  const [a, b] = [rows[i - 1], rows[i]];
  const share = (time - a.time) / (b.time - a.time);
  const mix = (x, y) => (Array.isArray(x) ? x.map((v, k) => mix(v, y[k])) : x + share * (y - x));
  return Object.fromEntries(Object.keys(a).map(key => [key, mix(a[key], b[key])]));
}

/** Returns the row of the still picture, at which the torque has decreased by a third. */
function still_of(rows) {
  const most = Math.abs(rows[0].torque);
  return rows.find(row => Math.abs(row.torque) <= 0.67 * most) || rows[rows.length - 1];
}

/** Returns lengths [m], speed [m/s] and sense (1 or -1) of a glass on its orbit. `value(path)`: number of an entry. */
export const lengths_of = (value, sense) => ({
  radius: value('Glass/Contact radius'),
  foot: value('Glass/Foot radius'),
  tumbler: is_tumbler(value('Glass/Stem radius'), value('Glass/Contact radius')),
  height: value('Motion/Centre of mass height'),
  hand: value('Motion/Hand height'),
  orbit_radius: value('Motion/Orbit radius'),
  speed: value('Motion/Orbit speed'),
  sense
});

export class Scene {
  /** `dragged(height)` is called when the hand is moved [m above the table]. */
  constructor(dragged) {
    Object.assign(this, { dragged, time: 0, plays: false });
    this.drawing = new Drawing();
    this.svg = this.drawing.svg;
    this.why = h('p', { class: 'why' });
    this.button = h('button', { hidden: true, onclick: () => this.play(!this.plays) });
    this.slider = h('input', { hidden: true, type: 'range', min: 0, step: 'any', 'aria-label': t.time, oninput: () => this.go_to(Number(this.slider.value)) });
    this.caption = h('figcaption', {}, h('b', {}, `${t.title}. `), t.caption);
    this.id = 'scene';
    const controls = h('div', { class: 'controls' }, this.button, this.slider);
    this.beside = h('div', {}, this.svg, this.drawing.number, controls, this.caption);
    this.tabs = h('div', { class: 'controls', role: 'group' });
    this.node = h('figure', { id: this.id, class: 'drawing' }, this.why, this.tabs, this.beside);
    this.svg.addEventListener('pointerdown', e => this.drag(e));
    const { grip } = this.drawing;
    if (dragged) grip.classList.add('handle');
    else grip.remove();
    grip.addEventListener('touchstart', e => e.preventDefault(), { passive: false }); // prevents scrolling
    this.play(false);
  }

  set(given) {
    const [same, fell] = [this.given && this.given.rows.length > 1, this.given?.falls];
    this.given = given;
    this.node.classList.remove('waits');
    const { rows } = given;
    const still = still_of(rows);
    this.drawing.set(given, still);
    this.end = rows[rows.length - 1].time;
    this.slider.max = this.end + (given.falls ? 0.15 : 0);
    this.button.hidden = this.slider.hidden = rows.length < 2 && !given.falls;
    this.why.textContent = given.why;
    this.svg.setAttribute('aria-label', `${t.title}. ${given.why}`);
    if (given.falls ? !fell : !same || fell) {
      const shows_fall = given.falls && !matchMedia('(prefers-reduced-motion: reduce)').matches;
      this.time = shows_fall ? Math.max(0, this.end - 0.03) : given.falls ? this.end + 0.15 : still.time;
      this.play(shows_fall);
    }
    this.go_to(Math.min(this.time, Number(this.slider.max)));
  }

  /** Greys the picture until a new answer is available. The hand is drawn at its new height. */
  wait(hand) {
    this.node.classList.add('waits');
    Object.assign(this.given, { hand });
    this.go_to(this.time);
  }

  go_to(time) {
    this.time = time;
    this.slider.value = time;
    this.slider.setAttribute('aria-valuetext', `${shown(time, '.2f')} s`);
    this.drawing.draw(between(this.given.rows, time), time);
  }

  play(plays) {
    this.plays = plays;
    this.button.textContent = plays ? t.pause : t.play;
    this.button.setAttribute('aria-pressed', String(plays));
    if (!plays || this.runs) return;
    let before = performance.now();
    const frame = now => {
      this.runs = this.plays && (this.given.rows.length > 1 || this.given.falls);
      if (!this.runs) return;
      const next = this.time + Math.min(0.05, (now - before) / 1e3) / slower;
      before = now;
      if (this.given.falls && next > Number(this.slider.max)) this.play(false);
      this.go_to(this.plays && next > Number(this.slider.max) + 0.1 ? 0 : next);
      requestAnimationFrame(frame);
    };
    this.runs = true;
    requestAnimationFrame(frame);
  }

  drag(event) {
    const by_hand = event.target === this.drawing.grip;
    const { clientX, clientY } = event;
    const { drawing, given } = this;
    const [{ camera, looked }, { hand }] = [drawing, given];
    const per_mm = Math.min(this.svg.clientWidth / width, this.svg.clientHeight / height) * (camera.focus / camera.distance) * Math.cos(camera.elevation);
    const move = e => {
      if (by_hand) {
        const at = hand - 1e-3 * ((e.clientY - clientY) / per_mm);
        this.dragged(Math.max(0.002, Math.min(2.4 * given.height, at)));
      } else {
        drawing.looked = looked - (e.clientX - clientX) / 150;
        this.go_to(this.time);
      }
    };
    follow(this.svg, event, move);
    event.preventDefault();
  }

  add_tab(above) {
    const looks = { beside: this.beside, above };
    const show = name => {
      Object.entries(looks).forEach(([key, node], i) => {
        node.hidden = key !== name;
        this.tabs.children[i].setAttribute('aria-pressed', String(key === name));
      });
    };
    this.tabs.replaceChildren(...Object.keys(looks).map(key => h('button', { onclick: () => show(key) }, t[key])));
    this.node.append(above);
    show('beside');
  }

  alone() {
    return copy_of(this.svg, t.title, this.given.why);
  }
}
