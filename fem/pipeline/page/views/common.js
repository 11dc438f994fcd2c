// Sections that every page has.
export const study = doc => {
  const changed = doc.tables.study_differences?.values[0]?.length > 0;
  return [
    {
      title: 'The study',
      text: changed
        ? 'What differs from the defaults (stemware defaults):'
        : 'Everything has its default value (stemware defaults).',
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
      'The exact solution of the same model lies within value ± band, the error of the discretisation. The band contains ' +
        'neither effects that the model does not have (docs/limits.md) nor uncertain parameters such as μ, E or the mass; a ' +
        'sweep over drawn cases shows the latter. The list “without” of the budget shows effects that the model has, one ' +
        'removed at a time.',
      doc.words.mesh_for_goal
    ],
    tables: [
      { name: 'bands', title: 'The study as it is; harmonics not listed are zero' },
      { name: 'band_parts', title: 'Parts of the bands' }
    ]
  };

/** The columns of all entries of a study as a table like the others. */
export const table_of_entries = entries => {
  const keys = ['entry', 'value', 'unit', 'meaning'];
  return { keys, values: keys.map(key => entries.map(entry => entry[key])) };
};
