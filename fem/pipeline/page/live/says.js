// What the live page says of an answer, and its numbers.
import { $, band, data, digits, found, local, pair, say, sense, state, words } from './state.js';
import { band_text, end_of, harmonic_effect } from './pictures.js';
import { h } from '../js/dom.js';
import { shown } from '../js/words.js';

const still = omega => Math.abs(omega) < 1e-6;
let checked = null;

/** A change of the spin in per cent; nothing where there is no spin. */
function effect_text(all, omega) {
  if (!Number.isFinite(all) || still(omega)) return '';
  const percent = shown(all / omega - 1, '+.2f%');
  return (
    ' ' +
    say(state.harmonics === 1 ? words().effect_of_first : words().effect, percent, digits(all - omega), state.harmonics)
  );
}

function answer_text({ all, first_n, paper, contact }) {
  const t = words();
  const { omega } = first_n || all;
  const way = still(omega) ? t.still : omega * sense() < 0 ? t.against : t.along;
  const turns = still(omega)
    ? `${way}.`
    : say(t.answer, way, digits(omega), ((2 * Math.PI) / Math.abs(omega)).toFixed(2));
  const compared = first_n
    ? effect_text(all.omega, omega)
    : Number.isFinite(paper.omega)
      ? ' ' + say(t.paper_says, digits(paper.omega))
      : '';
  const fraction = contact?.contact_fraction;
  const lies = Number.isFinite(fraction)
    ? ' ' + (fraction < 0.9995 ? say(t.lifts, (100 * fraction).toFixed(0)) : t.full)
    : '';
  return turns + compared + lies;
}

function failure_text({ tips, refused, error }) {
  return tips ? words().tips : refused ? say(words().refused, error) : error;
}

function notes_of({ all, first_n, fit, tips, error, notes = [] }) {
  const t = words();
  return [
    state.unknown.length && say(t.unknown, state.unknown.map(word => word.slice(0, 60)).join(', ')),
    !all && tips && error,
    all && fit === 'near' && local(say(t.near, shown(band(), '.2e'))),
    ...notes,
    first_n?.standing === 'formal' && t.pulls
  ].filter(Boolean);
}

/** Compares the first answer with that of `stemware run`. */
function check({ all, was_cold }) {
  if (checked !== null || !was_cold || Object.keys(state.changes).length || !Number.isFinite(all.omega)) return;
  checked = Math.abs(all.omega - pair().here) < data.tolerance;
  const text = say(checked ? words().check_ok : words().check_bad, digits(all.omega, 10), digits(pair().omega, 10));
  $('check').textContent = local(text);
  $('check').classList.toggle('falls', !checked);
}

export function facts(ms) {
  const { all, contact, fit } = found.answer;
  if (!all) return $('facts').replaceChildren();
  const f = words().facts;
  const end = end_of(all);
  const number = (value, n, unit) => (Number.isFinite(value) ? local(digits(value, n)) + unit : '–');
  const lean = contact && 1e6 * Math.hypot(contact.motion[1], contact.motion[2]);
  const rows = [
    [f.omega, number(all.omega, 6, ' rad/s')],
    [f.time_constant, number(all.time_constant || NaN, 3, ' s')],
    [f.moment_ratio, number(end?.moment_ratio, 4, '')],
    [f.fraction, number(contact && 100 * contact.contact_fraction, 1, ' %')],
    [f.normal, number(end?.normal_force, 3, ' N')],
    [f.tau0, all.at_rest ? number(1e3 * all.at_rest.torque, 4, ' mN m') : '…'],
    [f.lean, number(lean, 1, ' µrad')],
    [f.effect, harmonic_effect()],
    [f.band, band_text(fit)],
    [f.ms, `${ms.toFixed(0)} ms`]
  ];
  $('facts').replaceChildren(...rows.map(([name, value]) => h('div', {}, h('dt', {}, name), h('dd', {}, value))));
}

/** Says the answer. */
export function tell(ms) {
  const { answer } = found;
  const chosen = answer.all && (answer.first_n || answer.all);
  const spins = Number.isFinite(chosen?.omega);
  const without_spin = () =>
    chosen.falls ? say(words().falls, digits(chosen.last_spin, 3)) : say(words().no_spin, chosen.reason);
  const text = !chosen ? failure_text(answer) : local(spins ? answer_text(answer) : without_spin());
  $('answer').textContent = text;
  $('answer').classList.toggle('falls', !spins);
  $('notice').textContent = notes_of(answer).join(' ');
  if (chosen) check(answer);
  facts(ms);
}
