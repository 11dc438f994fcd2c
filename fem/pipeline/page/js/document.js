// The document of a page: the view of its verb.
import { converge } from '../views/converge.js';
import { fit } from '../views/fit.js';
import { run } from '../views/run.js';
import { show } from './sections.js';
import { sweep } from '../views/sweep.js';
import { truncate } from '../views/truncate.js';

const views = { run, truncate, converge, sweep, fit };

/** Shows the document of the page; whether there is one. */
export function show_document() {
  const main = document.querySelector('main');
  const doc = JSON.parse(document.getElementById('document').textContent);
  if (!doc) {
    main.remove();
    return false;
  }
  show(doc, views[doc.summary.verb](doc), main);
  return true;
}
