// The solver: the library of `stemware run` as WebAssembly. It handles one request at a time, in a worker, or
// in the page if workers are not supported.
let solver,
  bodies,
  data,
  pair = null;

export async function begin(given) {
  ({ data, bodies } = given);
  const module = await WebAssembly.compile(given.wasm);
  const imports = {}; // stubs: the library calls the system only to grow its memory and to exit
  for (const { module: from, name } of WebAssembly.Module.imports(module)) (imports[from] ||= {})[name] = () => 0;
  solver = (await WebAssembly.instantiate(module, imports)).exports;
  solver._initialize();
}

function string(text) {
  const bytes = new TextEncoder().encode(text + '\0');
  const at = solver.malloc(bytes.length);
  new Uint8Array(solver.memory.buffer).set(bytes, at);
  return at;
}
function read(at) {
  const memory = new Uint8Array(solver.memory.buffer);
  return JSON.parse(new TextDecoder().decode(memory.subarray(at, memory.indexOf(0, at))));
}

/** Returns the reply of the solver's function `name` to texts. */
function called(name, ...texts) {
  const places = texts.map(string);
  const reply = read(solver[name](...places));
  places.forEach(solver.free);
  return reply;
}
const set = (path, value) => called('explore_set', path, value);

// Unpacks a compliance of explore_page.cc: head and step, then the prediction residuals byte by byte.
function take(index, is_disc) {
  const at = data.bodies[index],
    doubles = (from, count) => new Float64Array(bodies.slice(from, from + 8 * count).buffer);
  const [n, , harmonics] = doubles(at, 3),
    head = 6 + n,
    [step] = doubles(at + 8 * head, 1),
    size = (n * (n + 1)) / 2 + 2 * n * n,
    count = (harmonics + 2) * size,
    numbers = new Float64Array(head + count),
    from = at + 8 * (head + 1),
    whole = new Int32Array(size); // of the present harmonic
  numbers.set(doubles(at, head));
  for (let place = 0, change = 0; place < count; ++place) {
    let z = 0;
    for (let b = 0; b < 4; ++b) z |= bodies[from + b * count + place] << (8 * b);
    change = (change + ((z >>> 1) ^ -(z & 1))) | 0;
    numbers[head + place] = (whole[place % size] += change) * step;
  }
  const spot = solver.malloc(numbers.length * 8);
  new Float64Array(solver.memory.buffer, spot, numbers.length).set(numbers);
  solver.explore_take(spot, is_disc ? 1 : 0);
  solver.free(spot);
}

/** Selects the compliance of an elastic table for the contact radius `wish` [m]. Returns false if it is not stored. */
const [radius, end_time] = ['Glass/Contact radius', 'Motion/End time'];
function take_disc(wish) {
  const { disc, discs, values } = data.pairs[pair];
  if (disc === null) return true;
  const own = Number(Object.fromEntries(values)[radius] ?? data.entries[radius]);
  const known = [[own, disc], ...discs].find(([at]) => Math.abs(at - wish) < 1e-6);
  if (known) take(known[1], true);
  return Boolean(known);
}

// Changed entries, relative to the values of the glass and the table.
let changed = {};
function choose(name, changes) {
  const stays = pair === name;
  if (!stays) {
    const chosen = data.pairs[name];
    solver.explore_begin();
    for (const [path, value] of chosen.values) set(path, value);
    take(chosen.foot, false);
    if (chosen.disc !== null) take(chosen.disc, true);
    solver.explore_ready(chosen.fineness);
    pair = name;
    changed = {};
  }
  const own = Object.fromEntries(data.pairs[name].values);
  let failure = null; // first entry that the solver refuses
  for (const path in { ...changed, ...changes }) {
    const wish = Object.hasOwn(changes, path) ? changes[path] : (own[path] ?? data.entries[path]);
    if (stays && changed[path] === changes[path]) continue;
    const why = set(path, wish);
    if (why.error) failure ||= { ...why, refused: true };
    else if (path === radius && !take_disc(Number(wish))) failure ||= { error: `${radius} = ${wish} m`, refused: true };
  }
  changed = failure ? {} : { ...changes };
  if (failure) pair = null;
  return { failure, stays };
}

const work = {
  solve: m => {
    const { failure, stays } = choose(m.pair, m.changes);
    if (failure) return failure;
    return { ...read(solver.explore_solve(m.harmonics, m.cold || !stays ? 1 : 0)), was_cold: m.cold || !stays };
  },
  curves: m => {
    set(end_time, (changed[end_time] = String(m.end))); // choose() restores it for the next study
    return read(solver.explore_curves());
  },
  budget: () => read(solver.explore_budget()),
  pressure: () => read(solver.explore_pressure())
};

/** Returns the reply { id, do, reply, ms } to a message. */
export function reply_to(message) {
  const start = performance.now();
  let reply;
  try {
    reply = work[message.do](message);
  } catch (error) {
    reply = { error: String(error), lost: true };
    pair = null;
  }
  return { id: message.id, do: message.do, reply, ms: performance.now() - start };
}
