// Sketch of the study, not to scale: the glass seen along its path, with its parameters.
import { drawing } from './files.js';
import { s } from './dom.js';
import { is_tumbler } from './space.js';
import { pressing } from './series.js';
import { shown } from './words.js';

const axis = 190; // axis of the drawn glass
const table = 341; // height of the table on the page
const centre = 224; // height of the centre of mass on the page
const outline =
  'M229.2,338.7C229.9,338.9 232.1,340 233.5,340C234.9,340 236.4,339.4 237.8,338.7C239.3,338 242.2,336.6 242.2,335.6' +
  'C242.2,334.7 241.7,334.1 237.8,333C234,332 224.8,331.1 219,329.1C213.2,327.1 206.7,324.7 203.1,321.1' +
  'C199.4,317.6 198.5,313.7 197.2,308.1C196,302.5 196,302.3 195.8,287.8C195.6,273.3 195.1,234.6 195.8,221.1' +
  'C196.5,207.6 196.3,211.4 200.2,206.6C204,201.8 213,197.9 219,192.1C225,186.3 232.1,180 236.4,171.8' +
  'C240.8,163.6 243.8,153.4 245.1,142.8C246.4,132.2 245.6,122.5 244.4,108C243.2,93.5 238.9,64.5 237.8,55.8' +
  'L142.2,55.8C141.1,64.5 136.8,93.5 135.6,108C134.4,122.5 133.6,132.2 134.9,142.8C136.2,153.4 139.2,163.6 143.6,171.8' +
  'C147.9,180 155,186.3 161,192.1C167,197.9 176,201.8 179.8,206.6C183.7,211.4 183.5,207.6 184.2,221.1' +
  'C184.9,234.6 184.4,273.3 184.2,287.8C184,302.3 184,302.5 182.8,308.1C181.5,313.7 180.6,317.6 176.9,321.1' +
  'C173.3,324.7 166.8,327.1 161,329.1C155.2,331.1 146,332 142.2,333C138.3,334.1 137.8,334.7 137.8,335.6' +
  'C137.8,336.6 140.7,338 142.2,338.7C143.6,339.4 145.1,340 146.5,340C147.9,340 150.1,338.9 150.8,338.7Z';

const tumbler = 'M234,340L243,331L254,56H126L137,331L146,340Z';

const text = (content, at, more = {}) => s('text', { ...at, ...more }, content);
const soft = { class: 'soft' };
const thin = (d, more = {}) => s('path', { d, fill: 'none', stroke: 'var(--soft)', 'stroke-width': 0.9, ...more });
const filled = (d, colour) => s('path', { d, fill: `var(--${colour})` });

/**
 * Returns the hand's force at rest; `inwards`: towards the orbit's centre; `along`: along the path against friction.
 */
const hand_force = given => `${shown(Math.hypot(given.force.inwards, given.force.along), '.3g')} N`;

function hand_nodes(given, hand) {
  return [
    thin(`M${axis - 14},${hand}H76`, { stroke: 'var(--c3)', 'stroke-width': 2.6 }),
    filled(`M66,${hand}l11,4.3v-8.6Z`, 'c3'),
    ...[-11, -1].map((dy, i) =>
      s('rect', { x: 120, y: hand + dy, width: i ? 64 : 78, height: 13, rx: 6.5, fill: '#f6dcc8', stroke: '#1c1e21' })
    ),
    text(`hand's force ${hand_force(given)}:`, { x: 12, y: hand - 62 }, { fill: 'var(--c3)' }),
    text(`${shown(given.force.along, '.3g')} N along v,`, { x: 12, y: hand - 46 }, soft),
    text(`${shown(given.force.inwards, '.3g')} N to the centre,`, { x: 12, y: hand - 30 }, soft),
    text(`${given.orbit_radius} away`, { x: 12, y: hand - 14 }, soft)
  ];
}

function press_nodes({ mean, inside, outside }) {
  const arrow = (force, x, label, at, anchor) => {
    const top = 350 + 24 * Math.min(2, Math.max(0, force / mean));
    return [
      thin(`M${x},${top.toFixed(1)}V352`, { stroke: 'var(--c1)', 'stroke-width': 4.5 }),
      filled(`M${x},344l-5,11h10Z`, 'c1'),
      text(label, at, { 'text-anchor': anchor, fill: 'var(--c1)' })
    ];
  };
  return [
    arrow(inside, 146.5, `${shown(inside, '.3g')} N/m`, { x: 136, y: 372 }, 'end'),
    arrow(outside, 233.5, `${shown(outside, '.3g')} N/m outside`, { x: 246, y: 384 }, 'start')
  ];
}

function length_nodes(given, hand) {
  return [
    s('circle', { cx: axis, cy: centre, r: 5.5, fill: 'var(--card)', stroke: 'var(--ink)', 'stroke-width': 1.4 }),
    filled(`M${axis},${centre}v-5.5a5.5,5.5 0 0 1 5.5,5.5ZM${axis},${centre}v5.5a5.5,5.5 0 0 1 -5.5,-5.5Z`, 'ink'),
    text(`centre of mass, ${given.mass}`, { x: 252, y: 212 }),
    thin(`M202,${centre}H340M202,${hand}H262`, { 'stroke-dasharray': '2 3' }),
    given.hand
      ? [
          thin(`M250,${centre}h8M254,${centre}V${hand}M250,${hand}h8`),
          text(given.offset, { x: 262, y: (centre + hand) / 2 + 5 })
        ]
      : [],
    thin(`M328,${centre}h8M332,${centre}V${table - 1}`),
    text(given.height, { x: 340, y: 288 }),
    thin(`M${axis},348V406M${axis},400H233.5M233.5,396v8`),
    text(`R ${given.radius}`, { x: 242, y: 408 })
  ];
}

export function sketch(doc) {
  const { sketch: given } = doc.words;
  const { Glass: glass } = doc.summary.parameters;
  const load = pressing(doc);
  const presses = load.inside || load.outside; // false if both sides have lifted off
  const hand = centre - 72.5 * given.hand;
  const side = given.clockwise ? 'in front' : 'behind';
  const into = given.clockwise
    ? s('circle', { cx: 24, cy: 47, r: 2 })
    : s('path', { d: 'M18.3,41.3L29.7,52.7M29.7,41.3L18.3,52.7' });
  const nodes = [
    text(`from ${side}`, { x: 12, y: 22 }, soft),
    s('g', { fill: 'none', stroke: 'var(--ink)', 'stroke-width': 1.2 }, s('circle', { cx: 24, cy: 47, r: 8 }), into),
    text(`v ${given.speed}`, { x: 38, y: 52 }),
    s('path', { d: is_tumbler(glass['Stem radius'], glass['Contact radius']) ? tumbler : outline, fill: 'var(--glass)', 'fill-opacity': 0.35, stroke: 'var(--ink)', 'stroke-width': 1.6 }),
    thin(`M${axis},41V349`, { 'stroke-dasharray': '7 3 1.5 3' }),
    thin(`M20,${table}H470`, { stroke: 'var(--ink)', 'stroke-width': 1.6 }),
    text(given.table, { x: 470, y: 360, 'text-anchor': 'end' }, soft),
    text(`μ ${given.friction}`, { x: 470, y: 332, 'text-anchor': 'end' }),
    hand_nodes(given, hand),
    length_nodes(given, hand),
    presses ? press_nodes(load) : []
  ];
  const where = { '-1': ` ${given.offset} below the centre of mass`, 1: ` ${given.offset} above the centre of mass` };
  const title =
    `The glass seen from ${side}: ${given.mass}, centre of mass ${given.height} above the table, rim R ${given.radius}, ` +
    `μ ${given.friction}; the hand's force is ${hand_force(given)}${where[given.hand] || ''}.`;
  const caption =
    'Seen along the path of the glass; a sketch, not to scale.' +
    (presses ? ' The blue arrows are how hard the rim presses at rest.' : '');
  const svg = s('svg', { viewBox: '0 0 480 420', role: 'img', 'aria-label': title }, nodes);
  return drawing({ id: 'glass', heading: 'What was computed', caption, title, svg });
}
