// Torques and spins at rounding level are shown as zero.
const share = 1e-9; // of the normal force times the radius, for torques

function zero(object, keys, limit) {
  for (const key of keys) if (typeof object?.[key] === 'number' && Math.abs(object[key]) < limit) object[key] = 0;
}

/** Sets torques, moments and spins of a document at rounding level to zero, in place. */
export function without_rounding({ summary, tables, words }) {
  const load = summary.load || summary.load_at_terminal;
  if (!load) return;
  const torque = share * load.normal_force * load.ring_radius;
  const spin = words.rounding || 0;
  for (const row of [summary.ring, summary.first_n, summary.paper]) {
    zero(row, ['tau_at_rest', 'tau_at_terminal'], torque);
    zero(row, ['omega_terminal'], spin);
  }
  for (const one of [summary.load, summary.load_at_terminal]) {
    zero(one?.moment, [0, 1], torque);
    zero(one, ['moment_ratio'], 2 * share);
  }
  for (const row of tables.motion || []) {
    zero(row, ['torque'], torque);
    zero(row, ['omega', 'yaw'], spin);
  }
  const limits = { torque, spin_up: spin };
  for (const name in limits)
    tables[name]?.values.forEach((column, i) => i && zero(column, column.keys(), limits[name]));
}
