// The page of a document, or one picture of it alone.
import { show_alone } from './sections.js';
import { show_document } from './document.js';

show_document();
const [, wanted, width] = /^#svg=(\w+)(?:&width=(\d+))?$/.exec(location.hash) || [];
if (wanted) show_alone(wanted, Number(width || 480));
document.body.dataset.complete = String(Math.round(performance.now()));
