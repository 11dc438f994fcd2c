// Draws one instant of the scene, a row of the document. The scale of forces is the same for all studies.
import { Camera, circle, Glass } from './space.js';
import { h, s } from './dom.js';
import { say, shown } from './words.js';
import { texts } from '../live/texts.js';

const t = texts.scene_words;
const turn = 2 * Math.PI;
export const [width, height] = [480, 340];
const margin = 14; // of the drawing on the page
const finger = 32; // radius of the hand's handle on the page
const pull = 50; // mm per N of the hand's force
const rub = 5 * pull; // mm per N of friction
const wall = 1.5; // mm per N/m of pressure
const twist = 1000; // rad per N m, round the stem
const rise = 5; // mm per turn of a long arrow round the stem

function make_parts() {
  const path = (colour, more) =>
    s('path', { fill: 'none', stroke: `var(--${colour})`, 'stroke-linejoin': 'round', 'stroke-linecap': 'round', ...more });
  const area = (colour, opacity, more) => path(colour, { fill: `var(--${colour})`, 'fill-opacity': opacity, ...more });
  return {
    dots: path('line', { 'stroke-width': 3 }),
    orbit: path('soft', { 'stroke-dasharray': '5 5' }),
    back: area('c1', 0.16, { stroke: 'none' }),
    back_edge: path('c1', { 'stroke-width': 2 }),
    mark: area('c5', 0.8, { 'stroke-width': 1 }),
    body: area('glass', 0.28, { stroke: 'var(--soft)' }),
    rims: path('soft', { 'stroke-width': 1.2 }),
    minus: path('c1', { 'stroke-width': 2.4 }),
    plus: path('c2', { 'stroke-width': 2.4 }),
    front: area('c1', 0.22, { stroke: 'none' }),
    front_edge: path('c1', { 'stroke-width': 2 }),
    centre: area('ink', 0.15, { stroke: 'var(--ink)', 'stroke-width': 1.5 }),
    hand: path('c3', { 'stroke-width': 6 }),
    inwards: path('c3', { 'stroke-width': 2, 'stroke-dasharray': '5 4' }),
    force: path('c3', { 'stroke-width': 3 }),
    torque: path('c2', { 'stroke-width': 4 })
  };
}
const [letter, line] = [9, 20]; // estimated sizes of text, larger on a small screen
const beside = ['hand', 'inwards', 'pressure', 'torque', 'inside', 'outside']; // labels placed beside the scene
const label = (fill, anchor) => s('text', { fill: `var(--${fill})`, 'text-anchor': anchor, 'paint-order': 'stroke', stroke: 'var(--card)', 'stroke-width': 4, 'stroke-linejoin': 'round' });

/**
 * Drawing of rows { rows, radius, height, hand, orbit_radius, sense, falls, normal_force, tumbler }. Lengths in metres.
 */
export class Drawing {
  constructor() {
    this.camera = new Camera(0, 0.45);
    this.looked = 0; // rotation of the view by the user
    this.parts = make_parts();
    this.words = { hand: label('c3'), inwards: label('c3'), centre: label('ink', 'start'), pressure: label('c1'), friction: label('soft', 'start'), torque: label('ink'), ...Object.fromEntries(['front', 'outside', 'inside'].map(place => [place, label('soft', 'middle')])) };
    this.grip = s('circle', { r: finger, fill: 'transparent' });
    this.number = h('p', { class: 'instant' });
    this.svg = s('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img' }, Object.values(this.parts), Object.values(this.words), this.grip);
    this.shows = () => true;
  }

  /** Sets the rows. `still`: row of the still picture, which is seen from behind. */
  set(given, still) {
    this.heading = still.orbit + (given.sense * turn) / 4;
    const { rows } = (this.given = given);
    const [first] = rows;
    this.most = Math.max(...rows.map(row => Math.abs(row.torque)), given.most || 0);
    this.end = rows[rows.length - 1].time;
    const R = 1e3 * given.radius;
    this.glass = new Glass(R, 1e3 * given.height, given.tumbler);
    this.wall = (wall * given.normal_force) / (turn * given.radius) || 0; // mm of the mean pressure
    // The sum of the friction arrows round the rim equals the force of the hand.
    const sum = first.friction[0].reduce((a, b) => a + b, 0);
    this.rub = sum ? (-2 * rub * first.hand[0]) / sum : 0; // an arrow stands for two points
    const tops = rows.map(row => this.wall * Math.max(0, ...row.load));
    const pulls = rows.map(({ hand }) => pull * Math.hypot(...hand));
    const rubs = rows.map(({ friction: [u, v] }) => this.rub * Math.max(0, ...u.map((x, k) => Math.hypot(x, v[k]))));
    const z = 1e3 * given.hand;
    if (!given.falls) this.glass.cut = Math.min(this.glass.height, 1.12 * Math.max(1e3 * given.height, z));
    this.reach = given.falls ? 1.1 * this.glass.height : Math.max(1.9 * R, R + 0.8 * Math.max(...rubs));
    this.circles = [[this.reach, 0], [this.glass.width_at(this.glass.cut), this.glass.cut], ...(given.falls ? [] : [[1.3 * R, Math.max(...tops)], [this.glass.width_at(z) + Math.max(...pulls), z]])];
  }

  draw(row, time) {
    const { camera, glass, given, parts, shows } = this;
    const travel = row.orbit + (given.sense * turn) / 4; // azimuth of the motion in the room
    camera.azimuth = this.heading + turn / 2 + 0.5 * given.sense + this.looked;
    camera.aim(this.circles, width - 2 * margin, height - 2 * margin);
    camera.middle = camera.middle.map(x => x + margin);
    const fallen = given.falls ? Math.max(0, (time - this.end) / 0.12) : 0;
    // The glass leans towards the maximum of the load; without a load it tips forwards.
    const hardest = row.load.length ? row.load.indexOf(Math.max(...row.load)) / row.load.length : 0;
    glass.lean_by(Math.min(1.45, 1.45 * fallen ** 2), travel + turn * hardest);
    const set = (name, d) => parts[name].setAttribute('d', d);
    const write = (name, place, text = '', dy = 0) => {
      const [seen, y] = place ? camera.see(place) : [0, 0];
      const is_beside = beside.includes(name);
      const x = is_beside ? this.beside_wall(seen, y + dy) : seen;
      const room = is_beside ? letter * text.length : 4;
      const [left, right] = x < width / 2 ? [room, 4] : [4, room];
      this.words[name].setAttribute('x', Math.max(left, Math.min(width - right, x)).toFixed(1));
      this.words[name].setAttribute('y', Math.max(14, Math.min(height - 4, y + dy)).toFixed(1));
      if (is_beside) this.words[name].setAttribute('text-anchor', x < width / 2 ? 'end' : 'start');
      this.words[name].textContent = place ? text : '';
    };
    this.draw_table(row, set);
    this.draw_wall(row, travel, set, write);
    for (const [place, angle] of [['front', 0], ['inside', (given.sense * turn) / 4], ['outside', (-given.sense * turn) / 4]])
      write(place, glass.lean ? null : circle(1.9 * glass.radius, 0, 1, travel + angle)[0], t.places[place], 5);
    for (const [name, d] of Object.entries(glass.paths(camera, row.yaw))) set(name, d);
    const centre = glass.at(0, 0, 1e3 * given.height);
    const [x, y] = camera.see(centre);
    set('centre', `M${x - 6},${y}a6,6 0 1 1 12,0a6,6 0 1 1 -12,0ZM${x - 6},${y}h12M${x},${y - 6}v12`);
    write('centre', centre, `\u2002\u2002${t.centre}`, given.hand > 0.9 * given.height ? 18 : -6);
    this.draw_hand(row, travel, set, write);
    this.draw_torque(row, set, write);
    this.part_names();
    const share = Math.round((100 * Math.abs(row.torque)) / this.most);
    const instant = say(t.instant, shown(row.time, '.2f'), shown(row.omega, '.2f'));
    this.number.textContent = shows('torque') && row.load.length ? `${instant}, ${this.most > 0 ? say(t.share, share) : t.no_torque}` : '';
  }

  /** Returns the x nearest to `x` at which a label at the height `y` does not overlap the pressure wall. */
  beside_wall(x, y) {
    const crossed = this.columns.filter(([top, base]) => top[1] < y + 8 && base[1] > y - 18).flat();
    const edges = crossed.map(place => place[0]);
    return x < width / 2 ? Math.min(x, ...edges.map(edge => edge - 8)) : Math.max(x, ...edges.map(edge => edge + 8));
  }

  /** Moves labels that overlap a higher label. Their sizes are estimated, because the drawing may be hidden. */
  part_names() {
    const number = (word, name) => Number(word.getAttribute(name));
    const boxes = Object.values(this.words).filter(word => word.textContent).map(word => {
      const size = letter * word.textContent.length;
      const left = { end: size, middle: size / 2 }[word.getAttribute('text-anchor')] || 0;
      return { word, x: number(word, 'x') - left, y: number(word, 'y'), size };
    });
    boxes.sort((a, b) => a.y - b.y).forEach((box, i) => {
      for (const above of boxes.slice(0, i))
        if (box.x < above.x + above.size && above.x < box.x + box.size && box.y < above.y + line) box.y = above.y + line;
      box.word.setAttribute('y', box.y.toFixed(1));
    });
  }

  draw_table({ orbit }, set) {
    const { camera, given } = this;
    const rho = 1e3 * given.orbit_radius;
    const [x, y] = [rho * Math.cos(orbit), rho * Math.sin(orbit)]; // centre of the glass
    const [step, far] = [40, Math.min(600, 1.6 * this.reach)];
    const near = [];
    for (let i = Math.ceil((x - far) / step); i <= (x + far) / step; ++i)
      for (let k = Math.ceil((y - far) / step); k <= (y + far) / step; ++k)
        if (Math.hypot(i * step - x, k * step - y) < far) near.push([i * step - x, k * step - y, 0]);
    set('dots', near.map(p => camera.path([p, p])).join(''));
    const reach = Math.min(turn / 2, far / rho);
    set('orbit', camera.path(circle(rho, 0, 40, orbit - reach, orbit + reach).map(p => [p[0] - x, p[1] - y, 0])));
  }

  draw_wall({ load, friction, turns }, travel, set, write) {
    const { camera, glass, given, shows } = this;
    const n = load.length;
    const r = 1.3 * glass.radius;
    const at = (k, high) => {
      const angle = travel + (turn * k) / n;
      return [r * Math.cos(angle), r * Math.sin(angle), high ? this.wall * Math.max(0, load[k % n]) : 0];
    };
    const walls = { front: '', back: '', front_edge: '', back_edge: '' };
    const stands = shows('pressure') && n > 0 && !glass.lean;
    for (let k = 0; stands && k < n; ++k) {
      const faces = camera.faces(travel + (turn * (k + 0.5)) / n) > 0;
      if (!(load[k] > 0 || load[(k + 1) % n] > 0)) continue;
      walls[faces ? 'front' : 'back'] += camera.path([at(k), at(k, true), at(k + 1, true), at(k + 1)], true);
      walls[faces ? 'front_edge' : 'back_edge'] += camera.path([at(k, true), at(k + 1, true)]);
    }
    Object.entries(walls).forEach(([name, d]) => set(name, d));
    this.columns = stands ? [...load.keys()].map(k => [camera.see(at(k, true)), camera.see(at(k))]) : [];
    const right = k => this.columns[k][0][0];
    const places = stands ? [...load.keys()].sort((j, k) => given.sense * (right(k) - right(j))) : [];
    write('pressure', stands ? at(places[0], true) : null, `\u2002${t.pressure}\u2002`);
    const arrows = { plus: '', minus: '' };
    let longest = { size: 0, to: null };
    if (shows('friction') && !glass.lean)
      turns.forEach((sense, k) => {
        if (k % 2) return; // every second point has an arrow
        const angle = travel + (turn * k) / turns.length;
        const [c, d] = [Math.cos(travel), Math.sin(travel)];
        const [u, v] = [this.rub * friction[0][k], this.rub * friction[1][k]];
        const from = [glass.radius * Math.cos(angle), glass.radius * Math.sin(angle), 0.5];
        const to = [from[0] + u * c - v * d, from[1] + u * d + v * c, 0.5];
        arrows[sense > 0 ? 'plus' : 'minus'] += camera.arrow(from, to, 7);
        const low = camera.see(to)[1]; // the label is placed where the friction points towards the viewer
        if (Math.hypot(u, v) > 1 && low > longest.size) longest = { size: low, to };
      });
    set('plus', arrows.plus);
    set('minus', arrows.minus);
    write('friction', longest.to, t.friction, 16);
  }

  draw_hand({ hand }, travel, set, write) {
    const { camera, glass, given, shows } = this;
    const z = 1e3 * given.hand;
    const there = shows('hand') && !glass.lean;
    const r = glass.width_at(Math.min(z, glass.cut)) + 4;
    set('hand', glass.lean ? '' : camera.path(glass.ring(r, z), true));
    const arrow = (along, across) => {
      const angle = travel + Math.atan2(across, along);
      const size = pull * Math.hypot(along, across);
      const at = reach => [reach * Math.cos(angle), reach * Math.sin(angle), z];
      return { d: camera.arrow(at(r), at(r + size), 10), tip: at(r + size) };
    };
    const [force, inwards] = [arrow(...hand), arrow(0, hand[1])];
    set('force', there ? force.d : '');
    set('inwards', there ? inwards.d : '');
    write('hand', there ? force.tip : null, say(t.hand, shown(Math.hypot(...hand), '#.3g')), -6);
    write('inwards', there ? inwards.tip : null, say(t.inwards, shown(Math.abs(hand[1]), '#.3g')), 16);
    const [x, y] = camera.see(glass.at(0, 0, z));
    this.grip.setAttribute('cx', x.toFixed(1));
    this.grip.setAttribute('cy', y.toFixed(1));
  }

  /** Draws the net torque as an arrow round the stem, with several turns if the torque is large. */
  draw_torque({ torque }, set, write) {
    const { camera, glass, given, parts, shows } = this;
    const reach = twist * torque;
    const [r, z] = [0.85 * glass.radius, 0.28 * glass.height];
    if (!shows('torque') || glass.lean || Math.abs(reach) < 0.05) return (set('torque', ''), write('torque', null));
    const from = camera.azimuth - Math.sign(reach) * Math.min(Math.abs(reach) / 2, 0.4 * turn);
    const n = Math.ceil(Math.abs(reach) * 6) + 2;
    const arc = circle(r, z, n, from, from + reach).map(([x, y], k) => [x, y, z + (rise * reach * k) / n / turn]);
    set('torque', camera.path(arc) + camera.arrow(arc[n - 1], arc[n], 12, 12));
    write('torque', circle(r, arc[n][2], 1, camera.azimuth - (given.sense * turn) / 4)[0], `\u2002${say(t.torque, shown(1e3 * Math.abs(torque), '#.4g'))}\u2002`, 5);
    return parts.torque.setAttribute('stroke', reach > 0 ? 'var(--c2)' : 'var(--c1)');
  }
}
