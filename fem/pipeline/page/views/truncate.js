// What `stemware truncate` shows.
import { beginning, fewer_harmonics, files, study } from './common.js';
import { load_polar, spectrum } from './load.js';
import { shown } from '../js/words.js';

export function truncate(doc) {
  const { words, summary } = doc;
  const how = words.one_way
    ? 'One-way: the load of rest, kept at every spin, loses some of its harmonics; neither contact nor friction is solved again.'
    : 'In balance at every spin: the friction of the harmonics that are kept enters the moment that the table has to provide, and that moment the contact, which has its whole pressure.';
  return {
    ...beginning(doc),
    sections: [
      fewer_harmonics(doc, [how, words.reasons]),
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
