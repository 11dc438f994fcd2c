// What `stemware truncate` shows.
import { beginning, fewer_harmonics, files, study } from './common.js';
import { load_polar, spectrum } from './load.js';
import { shown } from '../js/words.js';

export function truncate(doc) {
  const { words, summary } = doc;
  const how = words.one_way
    ? 'One-way: the load at rest, used at every spin, is truncated; neither contact nor friction is solved again.'
    : 'Two-way: at every spin the friction of the harmonics kept enters the required moment, and the moment enters the contact, which has its whole pressure.';
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
