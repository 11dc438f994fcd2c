// Draws one instant of the scene: a row of the document.
import { Camera, circle, Glass, height_of_glass } from './space.js';
import { h, s } from './dom.js';
import { say, shown } from './words.js';
import { texts } from '../live/texts.js';

const t = texts.scene_words;
const turn = 2 * Math.PI;
export const width = 480;
export const height = 420;
const wall_height = 30; // mm, of the mean pressure
const long = 32; // mm, of the friction of the mean load
const pull = 70; // mm, of the larger part of the hand's pull

function make_parts() {
  const path = (colour, more) =>
    s('path', { fill: 'none', stroke: `var(--${colour})`, 'stroke-linejoin': 'round', 'stroke-linecap': 'round', ...more }); // prettier-ignore
  const area = (colour, opacity, more) => path(colour, { fill: `var(--${colour})`, 'fill-opacity': opacity, ...more });
  return {
    dots: path('line', { 'stroke-width': 3 }),
    orbit: path('soft', { 'stroke-dasharray': '5 5' }),
    back: area('c1', 0.16, { stroke: 'none' }),
    back_edge: path('c1', { 'stroke-width': 2 }),
    body: area('glass', 0.28, { stroke: 'var(--soft)' }),
    label: area('c5', 0.9, { 'stroke-width': 1 }),
    label_line: path('ink', { 'stroke-width': 2 }),
    rims: path('soft', { 'stroke-width': 1.2 }),
    front: area('c1', 0.22, { stroke: 'none' }),
    front_edge: path('c1', { 'stroke-width': 2 }),
    minus: path('c1', { 'stroke-width': 2.4 }),
    plus: path('c2', { 'stroke-width': 2.4 }),
    hand: path('c3', { 'stroke-width': 6 }),
    force: path('c3', { 'stroke-width': 2.5 }),
    torque: path('c2', { 'stroke-width': 4 })
  };
}

/** The drawing of rows { rows, radius, height, hand, orbit_radius, sense, falls }, lengths in metres. */
export class Drawing {
  constructor() {
    this.camera = new Camera(0, 0.5, 420);
    this.looked = 0; // turned by hand
    this.parts = make_parts();
    this.hand_word = s('text', { fill: 'var(--c3)', 'text-anchor': 'end' });
    this.number = h('p', { class: 'instant' });
    this.svg = s('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img' }, Object.values(this.parts), this.hand_word);
    this.shows = () => true; // whether a part is shown
  }

  /** `still`: the row of the still picture, which is seen from behind. */
  set(given, still) {
    this.heading = still.orbit + (given.sense * turn) / 4;
    const { rows } = (this.given = given);
    this.most = Math.max(...rows.map(row => Math.abs(row.torque)), given.most || 0);
    this.end = rows[rows.length - 1].time;
    this.glass = new Glass(1e3 * given.radius, height_of_glass * 1e3 * given.height);
    this.camera.distance = Math.max(420, 2.15 * this.glass.height);
  }

  draw(row, time) {
    const { camera, glass, given, parts, shows } = this;
    const travel = row.orbit + (given.sense * turn) / 4; // of the direction of motion in the room
    camera.azimuth = this.heading + turn / 2 + 0.5 * given.sense + this.looked;
    camera.aim([0, 0, 0.43 * glass.height], width, height);
    const fallen = given.falls ? Math.max(0, (time - this.end) / 0.12) : 0;
    // Towards where it presses hardest; a glass that has no load falls forwards.
    const hardest = row.load.length ? row.load.indexOf(Math.max(...row.load)) / row.load.length : 0;
    glass.lean_by(Math.min(1.45, 1.45 * fallen ** 2), travel + turn * hardest);
    const set = (name, d) => parts[name].setAttribute('d', d);
    this.draw_table(row, set);
    this.draw_wall(row, travel, set);
    const paths = glass.paths(camera, row.yaw);
    for (const name of ['body', 'rims', 'label', 'label_line']) set(name, paths[name]);
    parts.label.setAttribute('fill-opacity', paths.label_faces ? 0.9 : 0.15);
    parts.label.setAttribute('stroke-opacity', paths.label_faces ? 1 : 0.3);
    parts.label_line.setAttribute('stroke-opacity', paths.label_faces ? 0.7 : 0.1);
    this.draw_hand(row, travel, set);
    this.draw_torque(row, set);
    const share = Math.round((100 * Math.abs(row.torque)) / this.most);
    const instant = say(t.instant, shown(row.time, '.2f'), shown(row.omega, '.2f'));
    this.number.textContent = shows('torque') ? `${instant}, ${this.most > 0 ? say(t.share, share) : t.no_torque}` : '';
  }

  draw_table({ orbit }, set) {
    const { camera, given } = this;
    const rho = 1e3 * given.orbit_radius;
    const [x, y] = [rho * Math.cos(orbit), rho * Math.sin(orbit)]; // of the glass
    const step = 40;
    const near = [];
    for (let i = Math.ceil((x - 150) / step); i <= (x + 150) / step; ++i)
      for (let k = Math.ceil((y - 150) / step); k <= (y + 150) / step; ++k)
        if (Math.hypot(i * step - x, k * step - y) < 150) near.push([i * step - x, k * step - y, 0]);
    set('dots', near.map(p => camera.path([p, p])).join(''));
    const reach = Math.min(turn / 2, 170 / rho);
    set('orbit', camera.path(circle(rho, 0, 40, orbit - reach, orbit + reach).map(p => [p[0] - x, p[1] - y, 0])));
  }

  /** The pressure as a wall outside the rim, and friction in front of it. */
  draw_wall({ load, friction, turns }, travel, set) {
    const { camera, glass, shows } = this;
    const n = load.length;
    const r = 1.45 * glass.radius;
    const at = (k, high) => {
      const angle = travel + (turn * k) / n;
      return [r * Math.cos(angle), r * Math.sin(angle), high ? wall_height * Math.max(0, load[k % n]) : 0];
    };
    const walls = { front: '', back: '', front_edge: '', back_edge: '' };
    if (shows('pressure') && !glass.lean)
      for (let k = 0; k < n; ++k) {
        const faces = camera.faces(travel + (turn * (k + 0.5)) / n) > 0;
        if (!(load[k] > 0 || load[(k + 1) % n] > 0)) continue;
        walls[faces ? 'front' : 'back'] += camera.path([at(k), at(k, true), at(k + 1, true), at(k + 1)], true);
        walls[faces ? 'front_edge' : 'back_edge'] += camera.path([at(k, true), at(k + 1, true)]);
      }
    Object.entries(walls).forEach(([name, d]) => set(name, d));
    const arrows = { plus: '', minus: '' };
    if (shows('friction') && !glass.lean)
      turns.forEach((sense, k) => {
        if (k % 2) return; // a dozen arrows
        const angle = travel + (turn * k) / turns.length;
        const [c, d] = [Math.cos(travel), Math.sin(travel)];
        const [u, v] = [long * friction[0][k], long * friction[1][k]];
        const from = [glass.radius * Math.cos(angle), glass.radius * Math.sin(angle), 0.5];
        const to = [from[0] + u * c - v * d, from[1] + u * d + v * c, 0.5];
        arrows[sense > 0 ? 'plus' : 'minus'] += camera.arrow(from, to, 7);
      });
    set('plus', arrows.plus);
    set('minus', arrows.minus);
  }

  draw_hand({ hand }, travel, set) {
    const { camera, glass, given, shows } = this;
    const z = 1e3 * given.hand;
    const there = shows('hand') && !glass.lean;
    const r = glass.width_at(z) + 4;
    set('hand', there ? camera.path(glass.ring(r, z), true) : '');
    const scale = pull / Math.max(...hand.map(Math.abs), 1e-9);
    const part = (size, angle) => {
      const direction = angle + (size < 0 ? turn / 2 : 0);
      const at = reach => [reach * Math.cos(direction), reach * Math.sin(direction), z];
      return camera.arrow(at(r), at(r + scale * Math.abs(size)), 10);
    };
    set('force', there ? part(hand[0], travel) + part(hand[1], travel + turn / 4) : '');
    const word = camera.see(circle(r + 10, z, 1, camera.azimuth - turn / 4)[0]);
    this.hand_word.setAttribute('x', word[0].toFixed(1));
    this.hand_word.setAttribute('y', (word[1] - 8).toFixed(1));
    this.hand_word.textContent = there ? t.hand : '';
  }

  /** What is left of the torque: an arrow round the stem. */
  draw_torque({ torque }, set) {
    const { camera, glass, parts, shows } = this;
    const share = this.most > 0 ? torque / this.most : 0;
    const z = 0.37 * glass.height;
    const [r, reach] = [0.85 * glass.radius, 0.8 * turn * share];
    if (!shows('torque') || glass.lean || Math.abs(share) < 0.02) return set('torque', '');
    const from = camera.azimuth - reach / 2;
    const arc = circle(r, z, 32, from, from + reach);
    const before = circle(r, z, 1, from + reach - 0.25 * Math.sign(reach))[0];
    set('torque', camera.path(arc) + camera.arrow(before, arc[32], 12));
    return parts.torque.setAttribute('stroke', share > 0 ? 'var(--c2)' : 'var(--c1)');
  }
}
