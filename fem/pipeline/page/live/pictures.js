// Pictures of a live answer, made by the functions of the reports.
import { at_end, band, doc, found, pair } from './state.js';
import { footprint } from '../views/foot.js';
import { line_load } from '../views/load.js';
import { spin_up, torque } from '../views/spin.js';
import { texts } from './texts.js';
import { waterfall } from '../views/budget.js';
import { shown } from '../js/words.js';

/** Pictures by name: a check that the document has the data, and the function that makes the picture. */
const pictures = {
  load: [() => doc.summary.load_at_terminal, () => line_load(at_end())],
  torque: [() => doc.tables.torque, () => torque(doc)],
  spin: [() => doc.tables.spin_up, () => spin_up(doc)],
  budget: [() => doc.tables.waterfall?.length, () => waterfall(doc)],
  pressure: [() => doc.tables.foot, () => footprint(doc.tables.foot.footprint, 'pressure', '')]
};
/** Slow pictures, which are not updated while a control moves. */
export const calm = ['torque', 'spin', 'budget', 'pressure'];

export function picture(name) {
  const [is_known, make] = pictures[name];
  const given = is_known() && make();
  if (!given) return null;
  const named = { id: `live_${name}`, title: texts[name], words: '', caption: '' };
  return { ...given, ...named, marks: given.marks.filter(Boolean) };
}

/** Returns the relative change of the spin due to all harmonics beyond the first; "–" if it does not exist. */
export function harmonic_effect() {
  const { harmonic_effect: effect } = doc.summary;
  return Number.isFinite(effect?.relative) ? shown(effect.relative, '+.2f%') : '–';
}
export const band_text = () => (pair().band || found.answer.fit === 'near' ? `±${shown(band(), '.2e')} rad/s` : '–');
