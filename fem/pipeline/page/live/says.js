// Texts and numbers of the live page about an answer.
import { $, band, data, digits, doc, fall, found, hand, pair, sense, state, value_of } from './state.js';
import { band_text, harmonic_effect } from './pictures.js';
import { h } from '../js/dom.js';
import { say, shown } from '../js/words.js';
import { texts } from './texts.js';

export const seconds_of = omega => shown((2 * Math.PI) / Math.abs(omega), '#.3g');
const still = omega => Math.abs(omega) < 1e-6;
let checked = null;

/** Returns the change of the spin in per cent and in rad/s; an empty text without a spin. */
function effect_text(all, omega) {
  if (!Number.isFinite(all) || still(omega)) return '';
  const numbers = [shown(all / omega - 1, '+.2f%'), shown(all - omega, '+.3g')];
  return ' ' + say(state.harmonics === 1 ? texts.effect_of_first : texts.effect, ...numbers, state.harmonics);
}

function answer_text({ ring, first_n, paper, load_at_terminal: load }) {
  const t = texts;
  const { omega_terminal: omega } = first_n || ring;
  state.standing = [omega, value_of(hand)];
  const way = still(omega) ? t.still : omega * sense() < 0 ? t.against : t.along;
  const turns = still(omega)
    ? `${way}.`
    : say(t.answer, way, digits(omega), seconds_of(omega));
  const compared = first_n
    ? effect_text(ring.omega_terminal, omega)
    : Number.isFinite(paper.omega_terminal)
      ? ' ' + say(t.paper_says, digits(paper.omega_terminal))
      : '';
  const fraction = load?.contact_fraction;
  const lies = Number.isFinite(fraction)
    ? ' ' + (fraction < 0.9995 ? say(t.lifts, (100 * fraction).toFixed(0)) : t.full)
    : '';
  return turns + compared + lies;
}

const near_fall = 0.8; // fraction of the tipping moment
const close_to_fall = ({ share, highest }) =>
  say(texts.close, shown(Math.min(100 * share, 99), '.2g'), shown(1e3 * highest, '.2g'));
export function failure_text({ tips, refused, error }) {
  if (tips) return texts.tips;
  return refused ? say(texts.refused, error) : fall().share > near_fall ? [...last_known(), texts.too_close].join(' ') : error;
}

/** Returns sentences on the last balance, if there was one, and on the distance to tipping, if it is small. */
function last_known() {
  const is_study = !Object.keys(state.changes).length;
  const [omega, height] = state.standing || [is_study ? pair().omega : NaN, value_of(hand)];
  const last = Number.isFinite(omega) ? [say(texts.last, digits(omega), shown(1e3 * height, '.3g'))] : [];
  return [...(fall().share > near_fall ? [close_to_fall(fall())] : []), ...last];
}

export function tell_late() {
  $('answer').textContent = [...last_known(), texts.solving].join(' ');
}

function notes_of({ fit, notes = [] }) {
  const t = texts;
  const { ring: all, first_n } = doc.summary;
  return [
    state.unknown.length && say(t.unknown, state.unknown.map(word => word.slice(0, 60)).join(', ')),
    all && fit === 'near' && say(t.near, shown(band(), '.2e')),
    ...notes,
    first_n?.standing === 'formal' && t.pulls
  ].filter(Boolean);
}

/** Compares the first answer with the answer of `stemware run`. */
function check({ was_cold }) {
  const { omega_terminal: omega } = doc.summary.ring;
  if (checked !== null || !was_cold || Object.keys(state.changes).length || !Number.isFinite(omega)) return;
  checked = Math.abs(omega - pair().here) < data.tolerance;
  $('check').textContent = say(checked ? texts.check_ok : texts.check_bad, digits(omega, 10), digits(pair().omega, 10));
  $('check').classList.toggle('falls', !checked);
}

export function facts(ms) {
  const { ring, load_at_terminal: load } = doc.summary;
  if (!ring) return $('facts').replaceChildren();
  const f = texts.facts;
  const number = (value, n, unit) => (Number.isFinite(value) ? digits(value, n) + unit : '–');
  const rows = [
    [f.omega, number(ring.omega_terminal, undefined, ' rad/s')],
    [f.time_constant, number(ring.time_constant || NaN, 3, ' s')],
    [f.moment_ratio, number(load?.moment_ratio, 4, '')],
    [f.fraction, number(load && 100 * load.contact_fraction, 1, ' %')],
    [f.normal, number(load?.normal_force, 3, ' N')],
    [f.tau0, Number.isFinite(ring.tau_at_rest) ? number(1e3 * ring.tau_at_rest, undefined, ' mN m') : '…'],
    [f.lean, number(load?.tilt && 1e6 * Math.hypot(...load.tilt), 1, ' µrad')],
    [f.effect, harmonic_effect()],
    [f.band, band_text()],
    [f.ms, `${ms.toFixed(0)} ms`]
  ];
  $('facts').replaceChildren(...rows.map(([name, value]) => h('div', {}, h('dt', {}, name), h('dd', {}, value))));
}

export function tell(ms) {
  const { answer } = found;
  const chosen = doc.summary.first_n || doc.summary.ring;
  const spins = Number.isFinite(chosen?.omega_terminal);
  const without_spin = () =>
    chosen.fall ? say(texts.falls, digits(chosen.fall.omega)) : say(texts.no_spin, chosen.message);
  const text = !chosen ? failure_text(answer) : spins ? answer_text(doc.summary) : without_spin();
  $('answer').textContent = text;
  $('answer').classList.toggle('falls', !spins);
  $('notice').textContent = notes_of(answer).join(' ');
  if (chosen) check(answer);
  facts(ms);
}
