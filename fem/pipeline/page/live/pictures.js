// Pictures of a live answer: those of reports, with the words of the page's language.
import { at_end, band, doc, found, pair, state, words } from './state.js';
import { footprint } from '../views/foot.js';
import { line_load } from '../views/load.js';
import { spin_up, torque } from '../views/spin.js';
import { waterfall } from '../views/budget.js';
import { shown } from '../js/words.js';

/** What is drawn, by the name of its place on the page, and whether the document has what it needs. */
const pictures = {
  load: [() => doc.summary.load_at_terminal, () => line_load(at_end())],
  torque: [() => doc.tables.torque, () => torque(doc)],
  spin: [() => doc.tables.spin_up, () => spin_up(doc)],
  budget: [() => doc.tables.waterfall, () => waterfall(doc)],
  pressure: [() => doc.tables.foot, () => footprint(doc.tables.foot.footprint, 'pressure', '')]
};
export const names = Object.keys(pictures);
/** Pictures that keep what they show while something moves. */
export const calm = ['torque', 'spin', 'budget', 'pressure'];

/** A text of a picture in the language of the page; those without a translation are told to tests. */
function translated(text) {
  if (!text || state.language === 'en' || !/[a-z]{3}/.test(text)) return text;
  const own = words().picture_words[text];
  if (own === undefined) (window.untranslated ||= new Set()).add(text);
  return own ?? text;
}

/** A picture; null where there is nothing to draw. */
export function picture(name) {
  const [is_known, make] = pictures[name];
  const given = is_known() && make();
  return given ? in_language(given, `live_${name}`, words()[name]) : null;
}

/** A picture of reports on this page; `is_named`: its axes have their names already. */
export function in_language(given, id, title, is_named) {
  const axis = ({ label, rows, ...more }) => ({
    ...more,
    label: is_named ? label : translated(label),
    ...(rows && { rows: rows.map(translated) })
  });
  return {
    ...given,
    id,
    title,
    words: '',
    caption: '',
    x: axis(given.x),
    y: axis(given.y),
    ...(given.colours && { colours: { ...given.colours, label: translated(given.colours.label) } }),
    marks: given.marks.filter(Boolean).map(mark => ({ ...mark, name: translated(mark.name) }))
  };
}

/** All harmonics against the first alone, as the budget has them; nothing where that does not spin. */
export function harmonic_effect() {
  const { harmonic_effect: effect } = doc.summary;
  return Number.isFinite(effect?.relative) ? shown(effect.relative, '+.2f%') : '–';
}
export const band_text = () => (pair().band || found.answer.fit === 'near' ? `±${shown(band(), '.2e')} rad/s` : '–');
