// Pictures of the foot: pressures, stresses, its section and its rim.
import { outline, patches, strokes } from '../js/shapes.js';
import { circle, degrees, radians, travel } from './load.js';
import { note } from '../js/marks.js';
import { shown } from '../js/words.js';

const length = mm => (mm < 0.1 ? `${shown(1e3 * mm, '.3g')} µm` : `${shown(mm, '.3g')} mm`);

/**
 * Adds quadrilaterals between neighbouring cuts of a pressure map, with the mean of the pressures at their corners. A
 * map without cells has squares around its points.
 */
function cells_of({ theta, distance, pressure, is_grid }, at) {
  const polygons = [];
  const value = [];
  const spots = [];
  const add = (corners, values, spot) => {
    if (values.includes(null) || !values.some(p => p > 0)) return; // null: the foot has lifted off
    polygons.push(corners);
    value.push(values.reduce((sum, p) => sum + p, 0) / values.length);
    spots.push(spot);
  };
  for (let j = 0; j + (is_grid ? 1 : 0) < theta.length; ++j)
    for (let k = 0; k + (is_grid ? 1 : 0) < distance[j].length; ++k)
      if (!is_grid) {
        const [t, d, half] = [theta[j], distance[j][k], 1.2];
        const corners = [-half, half].flatMap(a => [at(t + a, d - a), at(t + a, d + a)]);
        add([corners[0], corners[1], corners[3], corners[2]], [pressure[j][k]], [t, d]);
      } else if (distance[j + 1][k + 1] !== undefined) {
        const corners = [[j, k], [j, k + 1], [j + 1, k + 1], [j + 1, k]];
        add(
          corners.map(([a, b]) => at(theta[a], distance[a][b])),
          corners.map(([a, b]) => pressure[a][b]),
          [(theta[j] + theta[j + 1]) / 2, (distance[j][k] + distance[j + 1][k + 1]) / 2]
        );
      }
  return { polygons, value, spots };
}

function pressures(map, at) {
  const colours = { range: [0, map.largest || 1], label: `pressure (${map.unit})` };
  const { polygons, value, spots } = cells_of(map, at);
  const words = i => [
    `θ = ${shown(spots[i][0], '.4g')}°, r − R = ${shown(spots[i][1], '.4g')} µm`,
    `p = ${shown(value[i], '.3g')} ${map.unit}`
  ];
  return { colours, mark: patches({ polygons, value, colours, words }) };
}

export function footprint(map, id, state) {
  if (!map) return null;
  const { colours, mark } = pressures(map, (t, d) => [t, d]);
  const m = map.measures;
  const from = m && (m.narrowest > 0 ? `${shown(m.narrowest, '.3g')} µm to ` : m.narrowest === 0 ? 'at most ' : '');
  const says = m
    ? ` Largest pressure ${shown(m.largest, '.3g')}${m.band ? ` ± ${shown(m.band, '.2g')}` : ''} ${map.unit} at θ = ${shown(m.azimuth, '.0f')}°, mean ${shown(m.mean, '.3g')} ${map.unit}; ` +
      `the contact is ${from}${shown(m.widest, '.3g')} µm wide${m.has_edge ? '' : ', measured as the band with 99 % of the load'}.`
    : '';
  return {
    id,
    title: `Pressure of the foot on the table ${state}`,
    colours,
    words: `up to ${shown(map.largest, '.3g')} ${map.unit}`,
    caption: `Unrolled: along the rim and across it, R the contact radius.${says}`,
    x: degrees,
    y: { label: 'r − R', unit: 'µm', digits: '.4g' },
    marks: [mark]
  };
}

/** Shows the pressure of the foot from above; radial distances from the rim are enlarged. */
export function foot_from_above({ foot }, { sketch }) {
  const { footprint: map, section, magnification } = foot;
  if (!map || !section) return null;
  const R = section.radius;
  const side = sketch.clockwise ? -1 : 1;
  const { colours, mark } = pressures(map, (t, d) => {
    const r = R + 1e-3 * magnification * d;
    return [r * Math.cos(radians(t)), r * Math.sin(radians(t))];
  });
  const half = Math.max(1.05 * section.edge, 1.2 * R);
  return {
    id: 'foot_from_above',
    title: 'Pressure of the foot on the table at rest',
    equal: true,
    aspect: 0.84,
    colours,
    words: `up to ${shown(map.largest, '.3g')} ${map.unit}`,
    caption: `Seen from above, through the glass. Distances from the rim (thin circle) are magnified ${shown(magnification)} times; v is the direction of travel.`,
    x: { range: [-half, half] },
    y: { range: [-half, half] },
    marks: [
      mark,
      circle(section.edge, { colour: 'glass' }),
      circle(R, { colour: 'c8', width: 0.6 }),
      ...travel(0, 0, 0.45 * R),
      strokes({ lines: [[0, 0, 0, 0.36 * side * R]], colour: 'ink', dash: '6 4', heads: 1 }),
      note({ x: 0, y: side * 0.4 * R, dy: side > 0 ? -24 : 16, text: 'to the orbit’s centre,' }),
      note({ x: 0, y: side * 0.4 * R, dy: side > 0 ? -6 : 34, text: `${sketch.orbit_radius} from here` })
    ]
  };
}

export function section_stress({ foot }) {
  const t = foot.stresses;
  if (!t) return null;
  const colours = { range: [0, t.largest || 1], label: 'stress (MPa)' };
  const polygons = t.stress.map((_, i) => [0, 1, 2, 3].map(k => [t.x[4 * i + k], t.z[4 * i + k]]));
  const words = i => [
    `x = ${shown(polygons[i][0][0], '.3g')} mm, z = ${shown(polygons[i][0][1], '.3g')} mm`,
    `${shown(t.stress[i], '.3g')} MPa`
  ];
  const [low, edge] = [Math.min(...t.z), Math.max(...t.x.map(Math.abs))];
  return {
    id: 'section_stress',
    title: 'The loaded foot at rest',
    equal: true,
    aspect: 0.6,
    colours,
    words: `largest stress ${shown(t.largest, '.3g')} MPa`,
    caption:
      `Section along the line to the orbit’s centre; displacements are magnified ${shown(t.magnification)} times, ` +
      `up to ${shown(t.move, '.2g')} µm. Largest stress of von Mises ${shown(t.largest, '.3g')} MPa.`,
    marks: [
      patches({ polygons, value: t.stress, colours, words, lines: true }),
      note({ x: -edge, y: low, dy: 22, anchor: 'start', text: 'to the orbit’s centre' }),
      note({ x: edge, y: low, dy: 22, anchor: 'end', text: 'outside' })
    ]
  };
}

const cells = ({ x, z }, lift = () => 0) =>
  x.map((radii, i) =>
    outline({
      x: radii,
      y: z[i].map((v, k) => v + lift(radii[k])),
      colour: 'glass',
      fill: 'glass',
      opacity: 0.25,
      width: 0.6
    })
  );

export function section({ foot }) {
  const t = foot.section;
  if (!t) return null;
  const { radius, edge, top, stem, thickness } = t;
  const step = 0.075 * edge; // spacing of the dimension lines
  const end = (x, y, more) => note({ x, y, soft: false, ...more });
  return {
    id: 'section',
    title: 'Section of the foot with its cells',
    equal: true,
    aspect: Math.max(0.34, Math.min(0.8, (top + 4.6 * step) / (1.4 * edge))),
    words: `R ${length(radius)}`,
    caption: t.crown > 0 ? `The rim is rounded with ${length(t.crown)}.` : '',
    x: { range: [-0.06 * edge, 1.34 * edge] },
    y: { range: [-2.9 * step, top + 1.5 * step] },
    marks: [
      ...cells(t),
      strokes({ lines: [[-0.05 * edge, 0, 1.1 * edge, 0], [radius, 0, radius, -1.1 * step], [edge, 0, edge, -2.1 * step]] }),
      strokes({ lines: [[0, -2.4 * step, 0, top + step]], dash: '12 4 2 4' }),
      strokes({ lines: [[stem, top, 1.14 * edge, top]], dash: '2 4' }),
      strokes({ lines: [[0, -step, radius, -step], [0, -2 * step, edge, -2 * step], [1.12 * edge, 0, 1.12 * edge, top], [radius, 0, radius, thickness]], colour: 'ink', heads: 2 }),
      strokes({ lines: [[0, top, stem, top]], colour: 'ink', width: 3 }),
      end(radius / 2, -step, { text: `R = ${length(radius)}`, dy: -4 }),
      end(radius / 2, -2 * step, { text: `foot ${length(edge)}`, dy: 15 }),
      end(1.14 * edge, top / 2, { text: length(top), anchor: 'start' }),
      end(radius, thickness, { text: length(thickness), dy: -7 }),
      note({ x: 0.03 * edge, y: top, text: 'cut, held', anchor: 'start', dy: -9 }),
      note({ x: 1.03 * edge, y: 0, text: 'table', anchor: 'start', dy: 16 })
    ]
  };
}

export function rim({ foot }) {
  const t = foot.section;
  if (!t) return null;
  const { radius, crown, inner, outer } = t;
  const reach = 3 * Math.max(radius - inner, outer - radius, 3e-4 * radius);
  const lift = r => (crown > 0 ? (r - radius) ** 2 / (2 * crown) : 0);
  return {
    id: 'rim',
    title: 'The rim above the table',
    equal: true,
    aspect: 0.5,
    words: crown > 0 ? `rounded with ${length(crown)}` : '',
    caption: `${crown > 0 ? `Rounded with ${length(crown)}. ` : ''}Orange: the part under load at any azimuth, ${length(outer - inner)} wide.`,
    x: { range: [radius - reach, radius + reach] },
    y: { range: [-0.4 * reach, 0.6 * reach] },
    marks: [
      ...cells(t, lift),
      strokes({ lines: [[radius - reach, 0, radius + reach, 0]] }),
      strokes({ lines: [[radius, -0.12 * reach, radius, 0.5 * reach]], dash: '12 4 2 4' }),
      strokes({ lines: [[inner, 0, outer, 0]], colour: 'c2', width: 4 }),
      strokes({ lines: [[inner, -0.16 * reach, outer, -0.16 * reach]], colour: 'ink', heads: 2 }),
      note({ x: radius, y: -0.16 * reach, text: `under load ${length(outer - inner)}`, soft: false, dy: 17 }),
      note({ x: radius - 0.97 * reach, y: 0, text: 'table', anchor: 'start', dy: 15 })
    ]
  };
}
