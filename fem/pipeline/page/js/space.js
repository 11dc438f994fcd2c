// Perspective view of the glass. Lengths in millimetres, z up.
import { place } from './marks.js';

const turn = 2 * Math.PI;

// Half of the outline of the glass: radius over the contact radius, and height over the total height, as in
// docs/figures/draw_glass.py.

const profile = [
  [1, 0], [1.1, 0.008], [1.18, 0.019], [1.1, 0.028], [0.67, 0.042], [0.3, 0.07], [0.17, 0.115],
  [0.13, 0.187], [0.13, 0.42], [0.23, 0.471], [0.45, 0.495], [0.67, 0.522], [0.9, 0.556], [1.07, 0.593],
  [1.2, 0.64], [1.27, 0.695], [1.27, 0.755], [1.25, 0.817], [1.19, 0.9], [1.1, 1]
];

const tumbler = [[1, 0], [1.12, 0.03], [1.16, 0.3], [1.26, 1]];
const height_of_glass = 2.46; // relative to the height of the centre of mass
const height_of_tumbler = 1.9;

export const is_tumbler = (stem, contact) => stem > 0.5 * contact;

const radius_at = (outline, share) => {
  const above = outline.findIndex(([, z]) => z >= share);
  const i = above > 0 ? above : above < 0 ? outline.length - 1 : 1;
  const [[r0, z0], [r1, z1]] = [outline[i - 1], outline[i]];
  return r0 + (r1 - r0) * Math.min(1, Math.max(0, (share - z0) / (z1 - z0 || 1)));
};

export class Camera {
  constructor(azimuth, elevation) {
    Object.assign(this, { azimuth, elevation });
  }

  /** Sets the scale so that circles { radius, height } round the axis fit into `width` and `height` on the page. */
  aim(circles, width, height) {
    const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    this.axes = [
      [-sa, ca, 0],
      [-se * ca, -se * sa, ce],
      [-ce * ca, -ce * sa, -se]
    ];
    Object.assign(this, { middle: [0, 0], focus: 1, distance: 4 * Math.max(...circles.flat()) });
    const places = circles.flatMap(([r, z]) => circle(r, z, 24)).map(p => this.see(p));
    const ends = [0, 1].map(i => [Math.min, Math.max].map(f => f(...places.map(p => p[i]))));
    this.focus = Math.min(...ends.map(([least, most], i) => [width, height][i] / (most - least)));
    this.middle = ends.map(([least, most], i) => [width, height][i] / 2 - (this.focus * (least + most)) / 2);
  }

  see(p) {
    const [right, up, depth] = this.axes.map(axis => axis.reduce((sum, x, i) => sum + x * p[i], 0));
    const scale = this.focus / (this.distance + depth);
    return [this.middle[0] + scale * right, this.middle[1] - scale * up];
  }

  path(places, close) {
    return places.map((p, i) => (i ? 'L' : 'M') + place(...this.see(p))).join('') + (close ? 'Z' : '');
  }

  arrow(from, to, head, least = 0) {
    const d = to.map((x, i) => x - from[i]);
    const n = Math.hypot(...d);
    if (n < 0.5) return '';
    const [u, v] = [d[0] / n, d[1] / n];
    const size = Math.max(least, Math.min(head, 0.6 * n));
    const wing = side => [to[0] - size * (u - side * 0.5 * v), to[1] - size * (v + side * 0.5 * u), to[2]];
    return this.path([from, to]) + this.path([wing(1), to, wing(-1)]);
  }

  /** Returns the cosine between a direction on the table and the direction to the viewer. */
  faces(angle) {
    return Math.cos(angle - this.azimuth);
  }
}

export const circle = (r, z, n = 60, from = 0, to = turn) =>
  Array.from({ length: n + 1 }, (_, k) => {
    const angle = from + ((to - from) * k) / n;
    return [r * Math.cos(angle), r * Math.sin(angle), z];
  });

/** Glass drawn up to the height `cut`. `lean`: its angle from the vertical. */
export class Glass {
  constructor(radius, centre, is_tumbler) {
    Object.assign(this, { radius, lean: 0, towards: 0, outline: is_tumbler ? tumbler : profile });
    this.height = this.cut = centre * (is_tumbler ? height_of_tumbler : height_of_glass);
  }

  /** Leans the glass by an angle about the point of the rim at the azimuth `towards`. */
  lean_by(lean, towards) {
    Object.assign(this, { lean, towards });
  }

  at(r, angle, z) {
    const p = [r * Math.cos(angle), r * Math.sin(angle), z];
    if (!this.lean) return p;
    const [c, s] = [Math.cos(this.towards), Math.sin(this.towards)];
    const [along, across] = [p[0] * c + p[1] * s - this.radius, -p[0] * s + p[1] * c];
    const [cos, sin] = [Math.cos(this.lean), Math.sin(this.lean)];
    const moved = this.radius + along * cos + z * sin;
    return [moved * c - across * s, moved * s + across * c, z * cos - along * sin];
  }

  width_at(z) {
    return this.radius * radius_at(this.outline, z / this.height);
  }

  ring(r, z, n = 48) {
    return Array.from({ length: n }, (_, k) => this.at(r, (turn * k) / n, z));
  }

  /** Returns the paths of the body, of the rims and of the mark that shows the rotation `yaw`. */
  paths(camera, yaw) {
    const { cut, height, radius, outline } = this;
    const heights = [...outline.map(([, z]) => z * height).filter(z => z < cut), cut];
    const edge = sign => heights.map(z => this.at(this.width_at(z), camera.azimuth + (sign * turn) / 4, z));
    const foot = Math.max(...outline.slice(0, 3).map(([r]) => r)) * radius;
    const sector = [-0.22, -0.11, 0, 0.11, 0.22].map(angle => this.at(foot, yaw + angle, 0.03 * height));
    return {
      body: camera.path([...edge(1), ...edge(-1).reverse()], true),
      rims: camera.path(this.ring(this.width_at(cut), cut), true) + camera.path(this.ring(foot, 0.019 * height), true),
      mark: camera.path([this.at(0, 0, 0.05 * height), ...sector], true)
    };
  }
}
