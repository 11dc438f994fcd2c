// Glasses on their orbits, seen from above in real time.
import { drawing } from './files.js';
import { s } from './dom.js';
import { say, shown } from './words.js';
import { texts } from '../live/texts.js';

const t = texts.above_words;
const turn = 2 * Math.PI;
const reach = 130; // radius of an orbit with its glass, on the page
const panel = 270;

const style =
  '@keyframes round{to{transform:rotate(-360deg)}}.round{animation:round linear infinite}' +
  '@media(prefers-reduced-motion:reduce){.round{animation:none}}';

/** Returns sizes on the page. They are to scale, unless the glass would be too small. */
function sizes({ radius, foot, orbit_radius, speed, sense }) {
  const true_rim = (reach * radius) / (orbit_radius + 1.9 * radius);
  const rim = Math.max(true_rim, 15);
  return {
    rim,
    foot: (rim * Math.min(1.4 * radius, Math.max(radius, foot || radius))) / radius,
    orbit: Math.min(reach - 1.9 * rim, (true_rim / radius) * orbit_radius),
    larger: rim > 1.05 * true_rim ? rim / true_rim : 0,
    sense,
    rate: speed / orbit_radius
  };
}

function turning(seconds, clockwise, ...children) {
  const style = `animation-duration:${seconds.toFixed(4)}s${clockwise ? ';animation-direction:reverse' : ''}`;
  return s('g', { class: 'round', style }, ...children);
}

function band_of(load, size, sense) {
  const points = load.map((value, i) => {
    const angle = (sense * turn) / 4 + (turn * i) / load.length;
    const r = size.foot * (1 + 0.35 * value);
    return `${(r * Math.cos(angle)).toFixed(1)},${(-r * Math.sin(angle)).toFixed(1)}`;
  });
  return s('path', { d: `M${points.join('L')}Z`, fill: 'var(--c1)', 'fill-opacity': 0.35 });
}

/** Returns the time of one turn as text. */
const turns_of = (omega, spins) =>
  spins ? say(t.turns, shown(turn / Math.abs(omega), '#.3g')) : omega === null ? t.none : t.still;

function glass_nodes({ title, omega, load }, x, size) {
  const { rim, foot, orbit, sense, rate } = size;
  const spins = omega !== null && Math.abs(omega) > 1e-6 * rate;
  const against = (omega || 0) - sense * rate; // spin relative to the rotating frame
  const line = (d, more) => s('path', { d, stroke: 'var(--ink)', 'stroke-width': 1.6, fill: 'none', ...more });
  const circle = (r, more) => s('circle', { r: r.toFixed(1), fill: 'none', stroke: 'var(--ink)', ...more });
  const [tip, base] = [-sense * 2.1 * rim, -sense * 1.65 * rim];
  const body = load
    ? [
        circle(foot, { fill: 'var(--glass)', 'fill-opacity': 0.3, 'stroke-width': 1.6 }),
        circle(rim, { stroke: 'var(--soft)', 'stroke-width': 0.8 })
      ]
    : circle(rim, { 'stroke-width': 3 });
  const says = turns_of(omega, spins);
  const words = (y, content, more) => s('text', { x, y, 'text-anchor': 'middle', ...more }, content);
  const dot = s('circle', { cx: rim.toFixed(1), r: Math.max(3, 0.16 * rim).toFixed(1), fill: 'var(--c2)' });
  const spinning = [body, line(`M0,0H${rim.toFixed(1)}`), dot];
  const orbiting = [
    load ? band_of(load, size, sense) : null,
    line(`M0,0V${base.toFixed(1)}`, { stroke: 'var(--c3)', 'stroke-width': 2.5 }),
    s('path', { d: `M-5,${base.toFixed(1)}H5L0,${tip.toFixed(1)}Z`, fill: 'var(--c3)' }),
    turning(Math.min(turn / Math.abs(against), 1e4), against < 0, ...spinning)
  ];
  const parts = [
    circle(orbit, { stroke: 'var(--soft)', 'stroke-dasharray': '6 5' }),
    s('circle', { r: 3, fill: 'var(--ink)' }),
    turning(
      turn / rate,
      sense < 0,
      line(`M0,0H${orbit.toFixed(1)}`, { stroke: 'var(--soft)', 'stroke-width': 0.8 }),
      s('g', { transform: `translate(${orbit.toFixed(1)},0)` }, orbiting)
    )
  ];
  return [
    words(22, title, { 'font-weight': 600 }),
    s('g', { transform: `translate(${x},160)` }, parts),
    words(302, says),
    spins ? words(321, `${shown(omega, '#.4g')} rad/s`, { class: 'soft' }) : null
  ];
}

/** Returns the drawing of glasses { title, omega, load } on an orbit. `lengths`: see lengths_of(). */
export function orbits(glasses, lengths) {
  const size = sizes(lengths);
  const width = panel * Math.max(2, glasses.length);
  const drawn = (glass, i) => glass_nodes(glass, ((i + 0.5) * width) / glasses.length, size);
  const seconds = shown(turn / size.rate, '#.3g');
  const title = glasses.map(({ title, omega }) => `${title}: ${turns_of(omega, omega)}`).join('. ');
  const caption = [
    say(t.caption, seconds),
    ...(glasses.some(({ load }) => load) ? [t.band] : []),
    size.larger ? say(t.larger, shown(size.larger, '.2g')) : t.to_scale
  ].join(' ');
  const svg = s('svg', { viewBox: `0 0 ${width} 330`, role: 'img', 'aria-label': title }, glasses.map(drawn));
  return drawing({ id: 'orbits', heading: t.title, caption, title, svg, style });
}
