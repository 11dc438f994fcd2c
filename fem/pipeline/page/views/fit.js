// What `stemware fit` shows.
import { beginning, files, study } from './common.js';
import { dots, line } from '../js/marks.js';
import { columns } from '../js/tables.js';

export function curve({ tables, summary }, run, i) {
  const t = columns(tables[`fit_of_run_${i + 1}`]);
  const is_angle = run.measured === 'angle';
  return {
    id: `fit_${i + 1}`,
    title: `Run ${i + 1}: ${run.name}`,
    words: `${run.points} points`,
    caption: `Noise of the residuals ${run.noise.toPrecision(3)} ${is_angle ? 'rad' : 'rad/s'}.`,
    x: { label: 'time', symbol: 't =', unit: 's', room: 0 },
    y: { label: is_angle ? 'yaw angle ψ' : 'spin ω', unit: is_angle ? 'rad' : 'rad/s', zero: true },
    marks: [
      dots({ x: t.time, y: t.measured, name: 'measured', colour: 'ink', hollow: true }),
      line({ x: t.time, y: t.fitted, name: 'fitted', colour: 'c1' })
    ]
  };
}

/** Where entries i and j lie together with 95 %; `label` names an entry. */
export function ellipse({ tables, summary }, i, j, label = path => path.split('/')[1]) {
  const id = `fit_ellipse_${i + 1}_${j + 1}`;
  const { x, y } = columns(tables[id]);
  const [one, other] = [i, j].map(k => summary.fit.entries[k]);
  const names = [one, other].map(entry => label(entry.entry));
  const axis = (k, entry, values) => {
    const [low, high] = [Math.min(...values), Math.max(...values)];
    return { label: names[k], unit: entry.unit, log: low > 0 && high > 10 * low };
  };
  return {
    id,
    title: `${names[0]} and ${names[1]}`,
    words: `correlation ${summary.fit.correlation[i][j].toPrecision(4)}`,
    caption: `Both lie within the curve with 95 %, by the noise; correlation ${summary.fit.correlation[i][j].toPrecision(4)}.`,
    x: axis(0, one, x),
    y: axis(1, other, y),
    marks: [
      line({ x, y, name: '95 %', colour: 'c2' }),
      dots({ x: [one.value], y: [other.value], name: 'fitted', colour: 'c1' })
    ]
  };
}

const ellipses = doc => doc.summary.fit.entries.flatMap((_, j) => [...Array(j).keys()].map(i => ellipse(doc, i, j)));

export function fit(doc) {
  const { summary } = doc;
  return {
    ...beginning(doc),
    sections: [
      {
        title: 'The fit',
        text: summary.fit.sentences,
        pictures: [summary.fit.runs.map((run, i) => curve(doc, run, i)), ellipses(doc)],
        tables: [
          { name: 'fit_entries', title: 'Fitted entries' },
          { name: 'fit_runs', title: 'Runs' }
        ]
      },
      study(doc),
      files(doc)
    ]
  };
}
