// Page of `stemware sweep`.
import { files, study } from './common.js';
import { grid_pictures } from './grid.js';

export function sweep(doc) {
  const { words, tables } = doc;
  return {
    title: words.title,
    answer: words.answer,
    sections: [
      {
        title: 'The cases',
        tables: [{ name: 'varied', title: 'Entries that differ from case to case' }],
        pictures: grid_pictures(doc)
      },
      { title: 'Smallest and largest values', tables: [{ name: 'ranges' }] },
      tables.failures && {
        title: 'Cases that failed',
        text: 'sweep.csv lists all of them.',
        tables: [{ name: 'failures' }]
      },
      study(doc),
      files(doc)
    ]
  };
}
