// The load round the rim from its Fourier series in the summary.
const turn = 2 * Math.PI;

export const value_of = ({ a, b }, angle) =>
  a.reduce((sum, factor, n) => sum + factor * Math.cos(n * angle) + b[n] * Math.sin(n * angle), 0);

export const truncated = ({ a, b }, n) => ({ a: a.slice(0, n + 1), b: b.slice(0, n + 1) });

/** Returns the load over its mean at `n` azimuths, 0 where the foot has lifted off. */
export const around = (load, n) =>
  Array.from({ length: n }, (_, i) => Math.max(0, value_of(load, (turn * i) / n) / load.a[0]));

/**
 * How hard the rim presses [N/m]: on average, towards the orbit's centre and away from it; the sense in which friction turns
 * the glass, and the side that is pressed harder: outside, inside or even. Nothing without a load.
 */
export function pressing({ summary: { load }, tables, words }) {
  if (!load?.a) return {};
  const sense = words.sketch.clockwise ? -1 : 1;
  const side = (sense * turn) / 4;
  // Where the foot has lifted off, the series oscillates about zero.
  const at = angle => Math.max(tables.load_lines ? 0 : -Infinity, value_of(load, angle)) / load.ring_radius;
  const [, b1 = 0] = load.b;
  const turns = Math.abs(b1) > 1e-9 * load.a[0] ? Math.sign(b1) : 0;
  return {
    mean: load.a[0] / load.ring_radius,
    inside: at(side),
    outside: at(-side),
    turn: turns,
    harder: turns === 0 ? 'even' : turns * sense < 0 ? 'outside' : 'inside'
  };
}
