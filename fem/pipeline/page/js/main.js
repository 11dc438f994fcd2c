// Shows the page of a document, or a single picture.
import { converge } from '../views/converge.js';
import { run } from '../views/run.js';
import { show_alone, show_document } from './sections.js';
import { sweep } from '../views/sweep.js';
import { truncate } from '../views/truncate.js';

show_document({ run, truncate, converge, sweep });
const [, wanted, width] = /^#svg=(\w+)(?:&width=(\d+))?$/.exec(location.hash) || [];
if (wanted) show_alone(wanted, Number(width || 480));
document.body.dataset.complete = String(Math.round(performance.now()));
