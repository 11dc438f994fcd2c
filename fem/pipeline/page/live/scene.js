// Two glasses on their orbits from above, in real time: the elastic foot and the paper's ring, with load and friction round the rim.
import { $, digits, found, local, sense, state, value_of, words } from './state.js';
import { end_of, load_at } from './pictures.js';
import { arrow } from '../js/shapes.js';
import { s } from '../js/dom.js';

const arcs = 72;
const arrows_round = 12;
const orbit = 96; // on the page
const seen = { omega: [0, 0], yaw: [0, 0], phi: Math.PI / 2 };
const target = { omega: [0, 0], time_constant: 0.3 };
let held = matchMedia('(prefers-reduced-motion: reduce)').matches;
let parts = [];

/** One glass: its group and the parts that turn. */
function make_part(x) {
  const part = {
    hand: s('path', { stroke: 'var(--soft)', 'stroke-width': 1.2 }),
    rim: s('g'),
    mark: s('path', { d: 'M0 0L30 0M24 -4L32 0L24 4', stroke: 'var(--ink)', 'stroke-width': 2.5, fill: 'none' }),
    friction: ['c1', 'c2'].map(colour => s('path', { fill: 'none', stroke: `var(--${colour})`, 'stroke-width': 1.6 })),
    torque: s('path', { fill: 'none', 'stroke-width': 4 }),
    name: s('text', { class: 'name', 'text-anchor': 'middle', y: 166 })
  };
  part.arrows = s('g', {}, part.friction);
  part.glass = s(
    'g',
    {},
    s('circle', { r: 46, fill: 'var(--card)', stroke: 'var(--line)' }),
    part.rim,
    part.mark,
    s('circle', { r: 3, fill: 'var(--ink)' }),
    part.arrows,
    part.torque
  );
  const path = s('circle', { r: orbit, fill: 'none', stroke: 'var(--line)', 'stroke-dasharray': '3 4' });
  const centre = s('circle', { r: 2.5, fill: 'var(--soft)' });
  part.node = s('g', { transform: `translate(${x} 150)` }, path, centre, part.hand, part.glass, part.name);
  return part;
}

/** The load of the contact next to an azimuth. */
function pointwise(theta) {
  const { all, contact } = found.answer;
  if (!contact?.azimuth.length) return load_at(end_of(all), theta);
  const away = contact.azimuth.map(a => Math.abs(((a - theta + 3 * Math.PI) % (2 * Math.PI)) - Math.PI));
  return contact.load[away.indexOf(Math.min(...away))];
}

function rim_nodes(loads, most) {
  const spot = angle => `${(40 * Math.cos(angle)).toFixed(2)} ${(-40 * Math.sin(angle)).toFixed(2)}`;
  return loads.map((load, k) => {
    const d = `M${spot((2 * Math.PI * k) / arcs)}A40 40 0 0 0 ${spot((2 * Math.PI * (k + 1.05)) / arcs)}`;
    const none = load < 1e-6 * most;
    const share = Math.round(12 + 88 * Math.min(1, load / most));
    const pressed = `color-mix(in srgb, var(--c1) ${share}%, var(--panel))`;
    const stroke = load < -1e-6 * most ? 'var(--c2)' : none ? 'var(--line)' : pressed;
    return s('path', { d, fill: 'none', stroke, 'stroke-width': none ? 2 : 9 });
  });
}

/** Draws what does not move. */
export function draw_scene() {
  const { answer } = found;
  if (!parts.length) {
    parts = [160, 480].map(make_part);
    $('scene').append(...parts.map(part => part.node));
  }
  const rows = answer?.all ? [answer.first_n || answer.all, answer.paper] : [null, null];
  [words().elastic, words().ring].forEach((name, i) => {
    const part = parts[i];
    const row = rows[i];
    const spins = Number.isFinite(row?.omega);
    part.name.textContent = local(name + (spins ? `: ${digits(row.omega, 3)} rad/s` : ''));
    const end = end_of(row);
    const whole = i === 0 && row === answer?.all;
    const load = theta =>
      whole ? pointwise(theta) : load_at(end, theta, row === answer.first_n ? state.harmonics : Infinity);
    part.loads = end ? Array.from({ length: arcs }, (_, k) => load((2 * Math.PI * (k + 0.5)) / arcs)) : null;
    part.most = part.loads ? Math.max(...part.loads) : 1;
    part.rim.replaceChildren(...(part.loads ? rim_nodes(part.loads, part.most) : []));
  });
  const end_spin = rows[0] ? (rows[0].omega ?? rows[0].last_spin) : 0;
  target.omega = [end_spin || 0, answer?.paper?.omega || 0];
  target.time_constant = answer?.all?.time_constant || target.time_constant;
}

/** Arrows against the slip round the rim, as long as the load is large: those that turn the glass clockwise, and the others. */
function friction_paths({ loads, most }, spin, speed, radius) {
  const paths = ['', ''];
  for (let k = 0; loads && k < arrows_round; ++k) {
    const theta = (2 * Math.PI * k) / arrows_round;
    const size = (26 * loads[Math.floor((k * arcs) / arrows_round)]) / most;
    if (!(size > 2)) continue;
    const [cos, sin] = [Math.cos(theta), Math.sin(theta)];
    const [u, v] = [speed - spin * radius * sin, spin * radius * cos];
    const length = Math.hypot(u, v) || 1;
    const d = arrow(51 * cos, -51 * sin, 51 * cos - (size * u) / length, -51 * sin + (size * v) / length, 5);
    paths[u * sin - v * cos > 0 ? 1 : 0] += d;
  }
  return paths;
}

/** Friction's torque at a spin, of the curve that is drawn beside, over the largest of it between rest and the end. */
function torque_at(curve, spin, end) {
  const { spin: at } = found.curves || {};
  if (!at || !curve) return null;
  const value = x => {
    const k = Math.max(1, at.findIndex(one => one >= x) === -1 ? at.length - 1 : at.findIndex(one => one >= x));
    return curve[k - 1] + ((curve[k] - curve[k - 1]) * (x - at[k - 1])) / (at[k] - at[k - 1]);
  };
  const most = Math.max(Math.abs(value(0)), Math.abs(value(end)));
  return most > 0 ? value(spin) / most : null;
}

/** A curved arrow over the glass, half a turn long for the torque at rest. */
function torque_path(share) {
  if (!(Math.abs(share) > 0.02)) return '';
  const reach = Math.PI * Math.max(-1, Math.min(1, share));
  const spot = angle => [22 * Math.cos(angle), -22 * Math.sin(angle)];
  const [from, to] = [spot(Math.PI / 2 - reach / 2), spot(Math.PI / 2 + reach / 2)];
  const before = spot(Math.PI / 2 + reach / 2 - 0.3 * Math.sign(reach));
  const head = arrow(...before, ...to, 10);
  return `M${from.map(x => x.toFixed(1))}A22 22 0 0 ${reach > 0 ? 0 : 1} ${to.map(x => x.toFixed(1))}${head}`;
}

function place(part, spin, yaw, curve, end) {
  const [x, y] = [orbit * Math.cos(seen.phi), -orbit * Math.sin(seen.phi)];
  const degrees = angle => ((-angle * 180) / Math.PI).toFixed(2);
  const heading = `rotate(${degrees(seen.phi + (sense() * Math.PI) / 2)})`;
  part.hand.setAttribute('d', `M0 0L${x.toFixed(2)} ${y.toFixed(2)}`);
  part.glass.setAttribute('transform', `translate(${x.toFixed(2)} ${y.toFixed(2)})`);
  part.rim.setAttribute('transform', heading);
  part.arrows.setAttribute('transform', heading);
  part.mark.setAttribute('transform', `rotate(${degrees(yaw)})`);
  const [speed, radius] = [value_of('Motion/Orbit speed') || 0.3, value_of('Glass/Contact radius') || 0.03];
  friction_paths(part, spin, speed, radius).forEach((d, i) => part.friction[i].setAttribute('d', d));
  const share = part.loads ? torque_at(curve, spin, end) : null;
  part.torque.setAttribute('d', torque_path(share));
  part.torque.setAttribute('stroke', share > 0 ? 'var(--c2)' : 'var(--c1)');
}

let before = performance.now();
function frame(now) {
  const dt = held ? 0 : Math.min(0.05, (now - before) / 1000);
  before = now;
  const rate = 1 - Math.exp(-dt / Math.max(0.02, target.time_constant));
  seen.phi += ((sense() * value_of('Motion/Orbit speed')) / (value_of('Motion/Orbit radius') || 1)) * dt;
  parts.forEach((part, i) => {
    seen.omega[i] += (target.omega[i] - seen.omega[i]) * rate;
    seen.yaw[i] += seen.omega[i] * dt;
    const { torque, of_n, of_paper } = found.curves || {};
    const curve = i ? of_paper : found.answer?.first_n ? of_n : torque;
    place(part, seen.omega[i], seen.yaw[i], curve, target.omega[i]);
  });
  requestAnimationFrame(frame);
}

export function start_scene() {
  const press = () => $('pause').setAttribute('aria-pressed', held);
  $('restart').onclick = () => Object.assign(seen, { omega: [0, 0], yaw: [0, 0], phi: Math.PI / 2 });
  $('pause').onclick = () => {
    held = !held;
    press();
  };
  press();
  requestAnimationFrame(frame);
}
