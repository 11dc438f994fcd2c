// The glass in space: where its places lie on the page, and the paths that draw it. Lengths in millimetres, z up.
import { place } from './marks.js';

const turn = 2 * Math.PI;

// Half of the outline of the drawn glass over its contact radius and its height, as docs/figures/draw_glass.py has it.
const profile = [
  [1, 0],
  [1.1, 0.008],
  [1.18, 0.019],
  [1.1, 0.028],
  [0.67, 0.042],
  [0.3, 0.07],
  [0.17, 0.115],
  [0.13, 0.187],
  [0.13, 0.42],
  [0.23, 0.471],
  [0.45, 0.495],
  [0.67, 0.522],
  [0.9, 0.556],
  [1.07, 0.593],
  [1.2, 0.64],
  [1.27, 0.695],
  [1.27, 0.755],
  [1.25, 0.817],
  [1.19, 0.9],
  [1.1, 1]
];
const label = [0.62, 0.8]; // its heights on the bowl
export const height_of_glass = 2.46; // over the height of the centre of mass

const radius_at = share => {
  const i = Math.max(
    1,
    profile.findIndex(([, z]) => z >= share)
  );
  const [[r0, z0], [r1, z1]] = [profile[i - 1], profile[i]];
  return r0 + (r1 - r0) * Math.min(1, Math.max(0, (share - z0) / (z1 - z0 || 1)));
};

/** A look at a place from an azimuth and an elevation, with perspective. */
export class Camera {
  constructor(azimuth, elevation, distance) {
    Object.assign(this, { azimuth, elevation, distance });
  }

  /** Puts `target` into the middle of a page of that size. */
  aim(target, width, height) {
    const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    Object.assign(this, { target, width, height, focus: 1.75 * Math.min(0.85 * width, height) });
    this.axes = [
      [-sa, ca, 0],
      [-se * ca, -se * sa, ce],
      [-ce * ca, -ce * sa, -se]
    ];
  }

  /** The place on the page. */
  see(p) {
    const d = p.map((x, i) => x - this.target[i]);
    const [right, up, depth] = this.axes.map(axis => axis.reduce((sum, x, i) => sum + x * d[i], 0));
    const scale = this.focus / (this.distance + depth);
    return [this.width / 2 + scale * right, this.height / 2 - scale * up];
  }

  path(places, close) {
    return places.map((p, i) => (i ? 'L' : 'M') + place(...this.see(p))).join('') + (close ? 'Z' : '');
  }

  /** An arrow of two strokes at its head. */
  arrow(from, to, head) {
    const d = to.map((x, i) => x - from[i]);
    const n = Math.hypot(...d);
    if (n < 1) return '';
    const [u, v] = [d[0] / n, d[1] / n];
    const size = Math.min(head, 0.6 * n);
    const wing = side => [to[0] - size * (u - side * 0.5 * v), to[1] - size * (v + side * 0.5 * u), to[2]];
    return this.path([from, to]) + this.path([wing(1), to, wing(-1)]);
  }

  /** How much a direction of the table points to the eye, from -1 to 1. */
  faces(angle) {
    return Math.cos(angle - this.azimuth);
  }
}

export const circle = (r, z, n = 60, from = 0, to = turn) =>
  Array.from({ length: n + 1 }, (_, k) => {
    const angle = from + ((to - from) * k) / n;
    return [r * Math.cos(angle), r * Math.sin(angle), z];
  });

/** The glass of a contact radius and a height, whose label stands at an azimuth; it may lean over its rim. */
export class Glass {
  constructor(radius, height) {
    Object.assign(this, { radius, height, lean: 0, towards: 0 });
  }

  /** Leans by an angle over the place of the rim at an azimuth. */
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
    return this.radius * radius_at(z / this.height);
  }

  ring(r, z, n = 48) {
    return Array.from({ length: n }, (_, k) => this.at(r, (turn * k) / n, z));
  }

  /** Paths of its body, its rims and, at `yaw`, its label. */
  paths(camera, yaw) {
    const side = (sign, [r, z]) => this.at(r * this.radius, camera.azimuth + (sign * turn) / 4, z * this.height);
    const edge = sign => profile.map(point => side(sign, point));
    const [top_r, top_z] = profile[profile.length - 1];
    const heights = Array.from({ length: 7 }, (_, i) => label[0] + ((label[1] - label[0]) * i) / 6);
    const on_bowl = (angle, share) => this.at(this.radius * radius_at(share), yaw + angle, share * this.height);
    const across = Array.from({ length: 9 }, (_, i) => -0.5 + i / 8);
    return {
      body: camera.path([...edge(1), ...edge(-1).reverse()], true),
      rims: camera.path(this.ring(top_r * this.radius, top_z * this.height), true) + camera.path(this.ring(1.18 * this.radius, 0.019 * this.height), true), // prettier-ignore
      label: camera.path(
        [
          ...across.map(angle => on_bowl(angle, label[0])),
          ...heights.map(share => on_bowl(0.5, share)),
          ...across.map(angle => on_bowl(-angle, label[1])),
          ...heights.map(share => on_bowl(-0.5, label[0] + label[1] - share))
        ],
        true
      ),
      label_line: camera.path(heights.map(share => on_bowl(0, share))),
      label_faces: camera.faces(yaw) > 0.1
    };
  }
}
