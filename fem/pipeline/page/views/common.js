// What every page has.
import { h } from '../js/dom.js';
import { orbits } from '../js/motion.js';
import { Scene } from '../js/scene.js';
import { en } from '../live/en.js';
import { sketch } from '../js/sketch.js';
import { truncation } from './spin.js';

/**
 * Why the glass turns, falls or is held, by what the two sides press; `offset` of the hand from the centre of mass, if that
 * is why.
 */
export function why(t, { falls, held }, { inside, outside }, offset) {
  if (falls) return t.tips;
  if (held) return t.held;
  const hand = offset < 0 ? t.hand_below : offset > 0 ? t.hand_above : offset === 0 ? t.hand_level : '';
  const even = Math.abs(outside - inside) <= 1e-6 * Math.abs(outside);
  return `${hand} ${even ? t.even : outside > inside ? t.outside : t.inside}`.trim();
}

/** Why the glass turns, beside how it turns, seen from above; without rows of its motion the latter alone. */
function turning(doc) {
  const above = orbits(doc);
  const { motion } = doc.tables;
  if (!motion) return above;
  const { Glass: glass, Motion: given, Load: load } = doc.summary.parameters;
  const is_given = load.Source === 'file' || load['Moment ratio'] >= 0;
  const falls = doc.words.numbers.falls;
  const held = given['Grip torque'] > 0 && doc.summary.ring.omega_terminal === 0;
  const scene = new Scene(en.scene_words);
  scene.set({
    rows: motion,
    radius: glass['Contact radius'],
    height: given['Centre of mass height'],
    hand: given['Centre of mass height'] + given['Force offset'],
    orbit_radius: given['Orbit radius'],
    sense: given['Orbit sense'] === 'clockwise' ? -1 : 1,
    falls,
    why: why(en.scene_words, { falls, held }, doc.words.load, is_given ? undefined : given['Force offset'])
  });
  scene.add_tab(above.node);
  return [scene, { id: above.id, node: h('template'), alone: above.alone }];
}

/** Title, inputs and answer, beside the sketch of the study and the glass on its orbit. */
export const beginning = doc => {
  const { title, inputs, answer } = doc.words;
  return { title, inputs, answer, head: [sketch(doc), turning(doc)] };
};

export const study = doc => {
  const changed = doc.tables.study_differences?.values[0]?.length > 0;
  return [
    {
      title: 'The study',
      text: changed
        ? 'Entries that differ from the defaults (stemware defaults):'
        : 'All entries have their default values (stemware defaults).',
      tables: changed && [{ name: 'study_differences' }]
    },
    { title: 'All parameters', folded: true, tables: [{ name: 'entries' }] }
  ];
};
export const files = doc => ({ title: 'Files', folded: true, files: doc.files });

export const bands = doc =>
  doc.tables.bands && {
    title: 'Error bands',
    folded: true,
    text: [
      'The exact solution of the model lies within value ± band (discretisation error). The band contains ' +
        'neither effects missing in the model (docs/limits.md) nor uncertain parameters such as μ, E or the mass; a ' +
        'sweep over random cases shows the latter. The list “without” of the budget shows the model without one effect ' +
        'at a time.',
      doc.words.mesh_for_goal
    ],
    tables: [
      { name: 'bands', title: 'Error bands of this study; harmonics not listed are zero' },
      { name: 'band_parts', title: 'Parts of the bands' }
    ]
  };

/** What the spin is with fewer harmonics of the load; remarks stand before and after how to read it. */
export const fewer_harmonics = (doc, [before, after] = []) => ({
  title: 'Fewer harmonics',
  text: [
    before,
    'No harmonic beyond the first changes the torque at rest. The bound on the change of τ_z follows from the omitted harmonics ' +
      'only, at the terminal spin of all harmonics. A negative minimum load is tensile (not physical). Rows ' +
      'that change the spin by less than 1e-9 are in truncation.csv only.',
    after
  ],
  pictures: [truncation(doc)],
  tables: [{ name: 'truncations', title: 'The answer with a truncated load' }]
});

/** The columns of all entries of a study as a table like the others. */
export const table_of_entries = entries => {
  const keys = ['entry', 'value', 'unit', 'meaning'];
  return { keys, values: keys.map(key => entries.map(entry => entry[key])) };
};
