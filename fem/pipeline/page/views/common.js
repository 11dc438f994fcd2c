// Common parts of all pages.
import { h } from '../js/dom.js';
import { orbits } from '../js/motion.js';
import { Scene, lengths_of } from '../js/scene.js';
import { pressing } from '../js/series.js';
import { shown } from '../js/words.js';
import { sketch } from '../js/sketch.js';
import { table_of } from '../js/tables.js';
import { texts } from '../live/texts.js';
import { torque_changes, truncation } from './spin.js';

/**
 * Returns the reason why the glass turns, tips or is held. `harder`: side with the larger load; `offset`: height of the
 * hand above the centre of mass, if the hand causes the moment.
 */
export function why({ falls, held }, { harder }, offset) {
  const t = texts.scene_words;
  if (falls) return t.tips;
  if (held) return t.held;
  const hand = offset < 0 ? t.hand_below : offset > 0 ? t.hand_above : offset === 0 ? t.hand_level : '';
  return `${hand} ${t[harder] || ''}`.trim();
}

/**
 * Returns the end of a run: the last spin, and whether the glass moves, tips, keeps spinning or is held by the fingers.
 */
export function ending({ summary: { ring, parameters }, words }) {
  const omega = ring.omega_terminal ?? ring.fall?.omega ?? 0;
  const moves = Math.abs(omega) >= words.rounding;
  const held = parameters.Motion['Grip torque'] > 0 && ring.omega_terminal === 0;
  return { omega, moves, falls: Boolean(ring.fall), spins: moves && !ring.fall, held };
}

/**
 * Returns the scene of the motion with a view of `glasses` from above; only this view if the document has no motion.
 */
function turning(doc, glasses) {
  const { parameters } = doc.summary;
  const sense = parameters.Motion['Orbit sense'] === 'clockwise' ? -1 : 1;
  const lengths = lengths_of(path => path.split('/').reduce((part, key) => part[key], parameters), sense);
  const above = orbits(glasses, lengths);
  const { motion } = doc.tables;
  if (!motion) return above;
  const { Motion: given, Load: load } = parameters;
  const is_given = load.Source === 'file' || load['Moment ratio'] >= 0;
  const end = ending(doc);
  const scene = new Scene();
  scene.set({
    ...lengths,
    rows: motion,
    normal_force: doc.summary.load.normal_force,
    falls: end.falls,
    why: why(end, pressing(doc), is_given ? undefined : given['Force offset'])
  });
  scene.add_tab(above.node);
  return [scene, { id: above.id, node: h('template'), alone: above.alone }];
}

/** Returns title, inputs, answer, sketch, and the scene of `glasses` if given. */
export const beginning = (doc, glasses) => {
  const { title, inputs, answer } = doc.words;
  return { title, inputs, answer, head: [sketch(doc), glasses && turning(doc, glasses)] };
};

export const study = ({ entries }) => {
  const changed = entries.filter(entry => entry.default !== undefined);
  const columns = (list, ...keys) => [{ name: 'entries', given: table_of(keys, list.map(entry => keys.map(key => entry[key]))) }];
  return [
    {
      title: 'The study',
      text: changed.length
        ? 'Entries that differ from the defaults (stemware defaults):'
        : 'All entries have their default values (stemware defaults).',
      tables: changed.length > 0 && columns(changed, 'entry', 'value', 'default', 'unit')
    },
    { title: 'All parameters', folded: true, tables: columns(entries, 'entry', 'value', 'unit', 'meaning') }
  ];
};
export const files = doc => ({ title: 'Files', folded: true, files: doc.files });

const mesh_for_goal = ({ goal }) =>
  Number.isFinite(goal?.band_of_mesh) &&
  `The mesh was made for the ${goal.name}: ${shown(goal.estimated_error, '.1e')} is the estimated error of its value; the ` +
    `mesh's part of the band is ${shown(goal.band_of_mesh, '.1e')}, the change of the value by another mesh.`;

export const bands = doc =>
  doc.tables.bands && {
    title: 'Error bands',
    folded: true,
    text: [
      'The exact solution of the model lies within value ± band (discretisation error). The band contains ' +
        'neither effects missing in the model (docs/limits.md) nor uncertain parameters such as μ, E or the mass; a ' +
        'sweep over random cases shows the latter. The list “without” of the budget shows the model without one effect ' +
        'at a time.',
      mesh_for_goal(doc.summary)
    ],
    tables: [
      { name: 'bands', title: 'Error bands of this study; harmonics not listed are zero' },
      { name: 'band_parts', title: 'Parts of the bands' }
    ]
  };

/** Returns the section on the spin with fewer harmonics. `before`, `after`: remarks around its explanation. */
export const fewer_harmonics = (doc, [before, after] = []) => ({
  title: 'The effect of each harmonic',
  text: [
    before,
    'Δτ_z(n) is the effect of the harmonics 2 … n on the torque of friction, under one load: that of the complete study ' +
      'at each spin, cut after n. The rest is the effect of the harmonics that are left out; the bound holds for it. At rest ' +
      'no harmonic beyond the first changes the torque. Each terminal spin is a balance of its own. Rows with a rest ' +
      'below 1e-9 of the torque at rest are in truncation.csv only.',
    after
  ],
  pictures: [torque_changes(doc), truncation(doc)],
  tables: [{ name: 'truncations', title: 'Torque and spin by the number of harmonics' }]
});
