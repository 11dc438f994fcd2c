// The page of a document: the view of its verb is shown, or one picture of it alone.
import { converge } from '../views/converge.js';
import { fit } from '../views/fit.js';
import { run } from '../views/run.js';
import { show, show_alone } from './sections.js';
import { sweep } from '../views/sweep.js';
import { table_of_entries } from '../views/common.js';
import { truncate } from '../views/truncate.js';

const views = { run, truncate, converge, sweep, fit };
const doc = JSON.parse(document.getElementById('document').textContent);
doc.tables.entries = table_of_entries(doc.entries);
show(doc, views[doc.summary.verb](doc), document.querySelector('main'));
const [, wanted, width] = /^#svg=(\w+)(?:&width=(\d+))?$/.exec(location.hash) || [];
if (wanted) show_alone(wanted, Number(width || 480));
document.body.dataset.complete = String(Math.round(performance.now()));
