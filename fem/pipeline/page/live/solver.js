// The solver in its worker, or in the page if workers are not supported. Only the latest request is solved;
// an older request is cancelled if it takes long.
import { $, all_harmonics, end_of_spin_up, errors, pair_name, state } from './state.js';
import { begin, reply_to } from './compute.js';

const longest = 500; // ms that a newer request waits for an older one
const patience = 15000; // ms, time limit of an answer
const pause = 180; // ms without a move before curves are drawn
let parts = null; // script and data of the worker, unpacked
let worker = null;
let ready = null;
let last_id = 0;
const waiting = new Map();

async function unpack(id) {
  const packed = Uint8Array.from(atob($(id).textContent.trim()), c => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Returns a promise of a worker. The promise is rejected if site or browser do not support workers. */
function begin_worker() {
  worker = new Worker(parts.script);
  ready = new Promise((done, failed) => {
    worker.onerror = e => failed(new Error(e.message || 'Worker'));
    worker.onmessage = ({ data: message }) => {
      if (message.lost) return failed(new Error(message.lost));
      if (message.ready) return done();
      take(message);
    };
  });
  worker.postMessage(parts.given);
  return ready;
}
function take(message) {
  waiting.get(message.id)?.(message);
  waiting.delete(message.id);
}

/** Starts the solver in the page. setTimeout() lets the browser draw the page before each answer. */
function begin_in_page() {
  worker = { postMessage: message => setTimeout(() => take(reply_to(message))) };
  return (ready = begin(parts.given));
}

/** Starts the solver. The promise is rejected if the start fails. */
export async function start_solver(data) {
  const [wasm, bodies] = await Promise.all(['wasm', 'bodies'].map(unpack));
  const text = new Blob([$('worker').textContent], { type: 'text/javascript' });
  parts = { script: URL.createObjectURL(text), given: { wasm, bodies, data } };
  try {
    return await begin_worker();
  } catch {
    return begin_in_page();
  }
}

function post(message) {
  const id = ++last_id;
  return new Promise(done => {
    waiting.set(id, done);
    ready.then(
      () => waiting.has(id) && worker.postMessage({ ...message, id }),
      () => {}
    );
  });
}

function cancel() {
  if (!worker.terminate) return; // in the page itself a running solve cannot be cancelled
  worker.terminate();
  begin_worker().catch(error => errors.push(String(error)));
  for (const done of waiting.values()) done({ cancelled: true });
  waiting.clear();
}

/** Solves requests; calls `show(reply, ms)`, `late(ms)` and `use(name, reply)`. */
export class Queue {
  constructor(told) {
    this.told = told;
    this.times = [];
    this.busy = true;
  }

  get rests() {
    return !this.busy && !this.wish;
  }

  /**
   * Sends a request to the worker. Returns undefined if a newer request cancels it or if it takes more than `most` ms.
   */
  async ask(message, most = patience) {
    this.busy = true;
    this.since = Infinity; // until the worker has started
    const started = () => (this.since = performance.now());
    ready.then(started, started);
    const end = setTimeout(cancel, most);
    const reply = await post(message);
    clearTimeout(end);
    clearTimeout(this.patience);
    this.busy = this.patience = false;
    return reply.cancelled ? null : reply;
  }

  next() {
    if (!this.wish) return false;
    const { cold } = this.wish;
    this.wish = null;
    this.solve(cold);
    return true;
  }

  /** Cancels the running request when it has run for `longest` ms. */
  tire() {
    const left = longest - (performance.now() - this.since);
    if (left > 0) this.patience = setTimeout(() => this.tire(), Math.min(left, longest));
    else cancel();
  }

  async solve(cold) {
    if (this.busy) {
      this.wish = { cold: cold || this.wish?.cold };
      if (worker && this.since && !this.patience) this.tire();
      return;
    }
    clearTimeout(this.resting);
    const harmonics = state.harmonics >= all_harmonics ? 0 : state.harmonics;
    const asked = await this.ask({ do: 'solve', pair: pair_name(), changes: { ...state.changes }, harmonics, cold });
    if (!asked && !this.wish) {
      this.told.late(patience);
      this.rest({ error: true });
    }
    if (asked) {
      const { reply, ms } = asked;
      this.times.push(ms);
      if (!this.wish) this.resting = setTimeout(() => this.rest(reply), pause);
      this.told.show(reply, ms, !this.wish);
    }
    this.next();
  }

  /** After a pause: solves from a cold start like `stemware run`, then computes the slow parts. */
  async rest(reply) {
    if (!this.rests) return (this.resting = setTimeout(() => this.rest(reply), pause));
    if (!reply.error && !reply.was_cold) return this.solve(true);
    // Near tipping, most models of the budget have no balance, and each failing search takes long.
    const parts = reply.error ? [] : ['pressure', 'curves', ...(reply.document.summary.ring.fall ? [] : ['budget'])];
    for (const name of parts) {
      const asked = await this.ask({ do: name, end: end_of_spin_up() }, name === 'curves' ? 2 * patience : patience);
      if (this.next()) return;
      if (!asked) break; // a cancelled worker has lost the study
      if (!asked.reply.error) this.told.use(name, asked.reply);
    }
    document.body.dataset.rested = String(this.times.length);
    this.told.rest();
  }

  begin() {
    this.busy = false;
    this.wish = null;
    this.solve(true);
  }
}
