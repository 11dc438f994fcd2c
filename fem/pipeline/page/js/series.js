// The load round the rim from its Fourier series in the summary.
const turn = 2 * Math.PI;

export const value_of = ({ a, b }, angle) =>
  a.reduce((sum, factor, n) => sum + factor * Math.cos(n * angle) + b[n] * Math.sin(n * angle), 0);

export const truncated = ({ a, b }, n) => ({ a: a.slice(0, n + 1), b: b.slice(0, n + 1) });

/** Returns the load over its mean at `n` azimuths, and 0 where the series is negative. */
export const around = (load, n) =>
  Array.from({ length: n }, (_, i) => Math.max(0, value_of(load, (turn * i) / n) / load.a[0]));

/**
 * Returns the load per length of the rim [N/m]: its mean, and its values inside (towards the orbit's centre) and
 * outside. `turn`: sense of the friction torque; `harder`: side with the larger load. Returns {} without a load.
 */
export function pressing({ summary: { load }, tables, words }) {
  if (!load?.a) return {};
  const sense = words.sketch.clockwise ? -1 : 1;
  const side = (sense * turn) / 4;
  // With lift-off, the truncated series oscillates about zero outside the contact; negative values are set to 0.
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
