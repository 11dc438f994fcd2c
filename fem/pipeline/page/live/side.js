// The glass from the side with hand, friction and normal force, in millimetres; newtons are drawn as lengths.
import { end_of } from './pictures.js';
import { found, value_of, words } from './state.js';
import { arrows, outline } from '../js/shapes.js';
import { line, note } from '../js/marks.js';
import { shown } from '../js/words.js';

const per_newton = 15; // mm
const mm = path => 1e3 * value_of(path);

/** Outline of a glass that stands on its foot, one half of it. */
function half_outline(foot, top) {
  const points = [
    [1, 0],
    [1, 0.02],
    [0.5, 0.045],
    [0.15, 0.07],
    [0.12, 0.42],
    [0.6, 0.5],
    [0.92, 0.6],
    [0.98, 0.75],
    [0.85, 1]
  ];
  return points.map(([r, z]) => [r * foot, z * top]);
}

function glass_marks(foot, top, angle, pivot) {
  const half = half_outline(foot, top);
  const whole = [...half, ...half.map(([x, z]) => [-x, z]).reverse()];
  const turned = whole.map(([x, z]) => [
    pivot + (x - pivot) * Math.cos(angle) + z * Math.sin(angle),
    -(x - pivot) * Math.sin(angle) + z * Math.cos(angle)
  ]);
  return outline({
    x: turned.map(p => p[0]),
    y: turned.map(p => p[1]),
    colour: 'soft',
    fill: 'glass',
    opacity: 0.3
  });
}

function force_marks(end, height) {
  const pull = -end.friction[0];
  const lever = end.moment ? (end.moment[1] / -end.normal_force) * 1e3 : 0;
  const force = (x, y, u, v, colour, name, value) =>
    arrows({ x: [x], y: [y], u: [u], v: [v], colour, width: 2, words: [[name, `${shown(value, '.4g')} N`]] });
  const t = words();
  const said = (x, y, text, anchor) => note({ x, y, text, anchor, soft: false });
  const right = pull < 0 ? -1 : 1;
  const outside = right > 0 ? 'start' : 'end';
  const inside = right > 0 ? 'end' : 'start';
  return [
    force(0, height, per_newton * pull, 0, 'c2', t.hand, pull),
    said(per_newton * pull + 4 * right, height, `${t.hand} ${shown(pull, '.3g')} N`, outside),
    force(0, -12, -per_newton * pull, 0, 'c1', t.fric, -pull),
    said(-per_newton * pull - 4 * right, -12, `${t.fric} ${shown(Math.abs(pull), '.3g')} N`, inside),
    force(lever, -26, 0, 26, 'c1', 'N', end.normal_force),
    said(lever, -33, `N = ${shown(end.normal_force, '.3g')} N, ${shown(lever, '.3g')} mm`, 'middle')
  ];
}

export function side() {
  const { answer } = found;
  const [radius, centre] = [mm('Glass/Contact radius'), mm('Motion/Centre of mass height')];
  const top = Math.max(1.9 * centre, 110);
  const foot = mm('Glass/Foot radius') || radius + 4;
  const lean = answer.contact ? -answer.contact.motion[1] : 0;
  const end = end_of(answer.all);
  const speed = value_of('Motion/Orbit speed');
  const acceleration = speed ** 2 / value_of('Motion/Orbit radius');
  return {
    equal: true,
    aspect: 0.78,
    x: { range: [-110, 110] },
    y: { range: [-42, top + 8] },
    caption: `v = ${shown(speed)} m/s, v²/ρ = ${shown(acceleration, '.3g')} m/s²`,
    marks: [
      line({ x: [-110, 110], y: [0, 0], colour: 'ink', width: 1.5, words: () => [''] }),
      glass_marks(foot, top, answer.tips ? 0.25 : lean, radius),
      note({ x: 0, y: centre, text: '●', soft: false }),
      note({ x: foot + 4, y: centre + 4, anchor: 'start', text: words().mass_centre }),
      note({ x: foot + 4, y: centre - 6, anchor: 'start', text: `${shown(centre, '.3g')} mm` }),
      end && force_marks(end, centre + mm('Motion/Force offset'))
    ]
      .flat()
      .filter(Boolean)
      .map(mark => ({ ...mark, extent: () => ({ x: [], y: [] }) }))
  };
}
