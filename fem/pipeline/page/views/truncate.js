// Page of `stemware truncate`.
import { beginning, fewer_harmonics, files, study } from './common.js';
import { load_polar, spectrum, table_of_harmonics } from './load.js';
import { shown } from '../js/words.js';

export function truncate(doc) {
  const { words, summary } = doc;
  const how = words.one_way
    ? 'One-way: the load at rest, used at every spin, is truncated; neither contact nor friction is solved again.'
    : 'Two-way: at every spin the friction of the harmonics kept enters the required moment, and the moment enters the contact, which has its whole pressure.';
  const { load, truncation } = summary;
  const failed = truncation.filter(row => row.message);
  const reasons = failed.map(row => `With ${row.harmonics} harmonics: ${row.message}.`);
  const glasses = [
    { title: 'all harmonics', omega: truncation[truncation.length - 1].omega_terminal },
    { title: 'first harmonic only', omega: truncation[0].omega_terminal }
  ];
  return {
    ...beginning(doc, glasses.slice(0, truncation.length)),
    sections: [
      fewer_harmonics(doc, [how, reasons]),
      {
        title: 'The load at rest',
        pictures: [load_polar(doc), spectrum(doc)],
        tables: [
          {
            name: 'load_harmonics',
            given: table_of_harmonics(doc),
            title: `Harmonics of the load over its mean, a_0 = ${shown(load.a[0])} N/rad; moment ratio ${shown(load.moment_ratio, '.4g')}`
          }
        ]
      },
      study(doc),
      files(doc)
    ]
  };
}
