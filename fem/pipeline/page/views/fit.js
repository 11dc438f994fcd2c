// What `stemware fit` shows.
import { beginning, files, study } from './common.js';
import { dots, line } from '../js/marks.js';
import { columns } from '../js/tables.js';
import { sketch } from '../js/sketch.js';

function curve({ tables, summary }, run, i) {
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

export function fit(doc) {
  const { words, summary } = doc;
  return {
    ...beginning(doc),
    head: [sketch(doc)],
    sections: [
      {
        title: 'The fit',
        text: words.remarks,
        pictures: summary.fit.runs.map((run, i) => curve(doc, run, i)),
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
