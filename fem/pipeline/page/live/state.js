// State of the live page: glass, table, number of harmonics, changes of the study, and answer.
import { shown } from '../js/words.js';
import { without_rounding } from '../js/rounding.js';

export const $ = id => document.getElementById(id);
export const data = JSON.parse($('data').textContent);
export const all_harmonics = 17; // last value of the slider of harmonics
export const state = {
  glass: data.glasses[0].name,
  table: data.tables[0].name,
  harmonics: all_harmonics,
  changes: {},
  lesson: 0, // current step; 0: none
  unknown: []
};
/** Last reply: { fit, notes, error, tips, refused, was_cold }. `is_last`: no newer request exists. */
export const found = { answer: null, is_last: true };
export const doc = { summary: {}, words: {}, tables: {} };
const own = ['measured']; // tables of the user, which a new answer does not replace
export function forget() {
  const kept = Object.fromEntries(own.filter(name => doc.tables[name]).map(name => [name, doc.tables[name]]));
  Object.assign(doc, { summary: {}, words: {}, tables: kept });
}
export function learn(part) {
  for (const key of ['summary', 'words', 'tables']) Object.assign(doc[key], part[key]);
  without_rounding(doc);
}
/** Returns the document with the load at the last spin as its load. */
export function at_end() {
  const { summary } = doc;
  return { ...doc, summary: { ...summary, load: { ...summary.load_at_terminal, cut: summary.first_n?.load } } };
}
export const [hand, centre, radius] = ['Motion/Hand height', 'Motion/Centre of mass height', 'Glass/Contact radius'];
const offset = 'Motion/Force offset'; // equals the height of the hand minus the height of the centre of mass
const rounded = metres => Number(metres.toFixed(9));
export const errors = [];
let entries = {};

/** Returns a number with four significant digits, or with `n` decimals. */
export const digits = (x, n) => shown(x, n === undefined ? '#.4g' : `.${n}f`);

export const pair_name = () => `${state.glass}|${state.table}`;
export const pair = () => data.pairs[pair_name()];
export const band = () => Math.max(data.near_band, pair().band || 0);

export function load_entries() {
  entries = {};
  for (const path in data.entries) entries[path] = { value: data.entries[path], acts: pair().acts.includes(path) };
  for (const [path, value] of pair().values) entries[path].value = value;
  if (!is_changed(offset)) return; // the address of the page has no force offset
  state.changes[hand] = String(rounded(value_of(centre) + value_of(offset)));
  delete state.changes[offset];
}
export const acts = path => entries[path]?.acts;
export const is_changed = path => Object.hasOwn(state.changes, path);
export const base_value = path => Number(entries[path]?.value ?? 0);
const text_of = path => (is_changed(path) ? state.changes[path] : (entries[path]?.value ?? ''));
export const value_of = path => Number(text_of(path));
/**
 * Returns the moment at rest over the maximum moment of a rigid ring with the contact radius (at a ratio of 1 the glass
 * tips), and the height of the hand at which the ratio is 1.
 */
export function fall() {
  const [h, c, R, mu] = [hand, centre, radius, 'Motion/Friction coefficient'].map(value_of);
  const k = value_of('Motion/Orbit speed') ** 2 / value_of('Motion/Orbit radius') / value_of('Motion/Gravity');
  const sum = k * k + mu * mu;
  const highest = (c * k * k + Math.sqrt(Math.max(0, sum * R * R - (c * k * mu) ** 2))) / sum;
  return { share: Math.hypot((h - c) * k, h * mu) / R, highest };
}
export const hand_offset = () => rounded(value_of(hand) - value_of(centre));
/** Scales a length of the foot with the contact radius, so that the foot keeps its shape. */
export const similar = length => (length * value_of(radius)) / base_value(radius);
/** Returns a time [s] after which the spin hardly changes, at least the end time of the study. */
export function end_of_spin_up() {
  const { omega_terminal, fall, tau_at_rest, time_constant } = doc.summary.ring;
  const torque = Math.abs(tau_at_rest) - value_of('Motion/Grip torque');
  const rise = Math.abs((omega_terminal ?? fall?.omega ?? 0) * value_of('Motion/Yaw inertia')) / torque || 0;
  const settling = Math.ceil(1.5 * rise + 4 * (time_constant || 0));
  return Math.max(value_of('Motion/End time'), Math.min(60, settling));
}
/** Returns true if the grip prevents the spin. */
export const is_held = () => value_of('Motion/Grip torque') > 0 && doc.summary.ring?.omega_terminal === 0;
export const sense = () => (text_of('Motion/Orbit sense') === 'clockwise' ? -1 : 1);

/** Drops the changes of entries that a newly selected glass or table sets. */
export function drop_changes(list, ...names) {
  for (const { name, sets } of list) if (names.includes(name)) for (const path of sets) delete state.changes[path];
}

export function parts_of_state() {
  const parts = { glass: state.glass, table: state.table, ...state.changes };
  if (state.harmonics < all_harmonics) parts.harmonics = state.harmonics;
  if (state.lesson) parts.lesson = state.lesson;
  return new URLSearchParams(parts);
}
export function remember() {
  const address = '#' + parts_of_state();
  try {
    history.replaceState(null, '', address);
  } catch {
    location.hash = address; // in an embedded page, replaceState() may fail
  }
}

/** Reads the state from the address; unknown parts are kept for a message. */
export function recall() {
  state.unknown = [];
  for (const [key, value] of new URLSearchParams(location.hash.slice(1) || $('live').dataset.state)) {
    const harmonics = Number(value);
    if (key === 'glass' && data.glasses.some(g => g.name === value)) state.glass = value;
    else if (key === 'table' && data.tables.some(g => g.name === value)) state.table = value;
    else if (key === 'harmonics' && Number.isInteger(harmonics) && harmonics > 0)
      state.harmonics = Math.min(harmonics, all_harmonics);
    else if (key === 'lesson' && harmonics >= 1 && harmonics <= 5) state.lesson = Math.floor(harmonics);
    else if (key.includes('/')) state.changes[key] = value;
    else state.unknown.push(`${key}=${value}`);
  }
}
