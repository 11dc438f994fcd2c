// What every page has.
import { orbits } from '../js/motion.js';
import { sketch } from '../js/sketch.js';
import { truncation } from './spin.js';

/** Title, inputs and answer, beside the sketch of the study and the glass on its orbit. */
export const beginning = doc => {
  const { title, inputs, answer } = doc.words;
  return { title, inputs, answer, head: [sketch(doc), orbits(doc)] };
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
