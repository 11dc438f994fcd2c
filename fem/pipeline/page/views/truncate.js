// What `stemware truncate` shows.
import { files, study } from './common.js';
import { load_polar, spectrum } from './load.js';
import { orbits } from '../js/motion.js';
import { shown } from '../js/words.js';
import { sketch } from '../js/sketch.js';
import { truncation } from './spin.js';

export function truncate(doc) {
  const { words, summary } = doc;
  const how = words.one_way
    ? 'One-way: the load of rest, kept at every spin, loses some of its harmonics; neither contact nor friction is solved again.'
    : 'In balance at every spin: the friction of the harmonics that are kept enters the moment that the table has to provide, and that moment the contact, which has its whole pressure.';
  return {
    title: words.title,
    inputs: words.inputs,
    answer: words.answer,
    head: [sketch(doc), orbits(doc)],
    sections: [
      {
        title: 'Fewer harmonics',
        text: [
          how,
          'No harmonic beyond the first changes the torque at rest. The bound on the change of τ_z follows from the harmonics left out alone, at the terminal spin of all harmonics. If the least load is negative, the table would have to pull. Rows that change the spin by less than 1e-9 stand in truncation.csv only.',
          words.reasons
        ],
        pictures: [truncation(doc)],
        tables: [{ name: 'truncations', title: 'The answer with the load cut off after some harmonics' }]
      },
      {
        title: 'The load at rest',
        pictures: [load_polar(doc), spectrum(doc)],
        tables: [
          {
            name: 'load_harmonics',
            title: `Harmonics of the load over its mean, a_0 = ${shown(words.load.mean)} N/rad; moment ratio ${shown(summary.load.moment_ratio, '.4g')}`
          }
        ]
      },
      study(doc),
      files(doc)
    ]
  };
}
