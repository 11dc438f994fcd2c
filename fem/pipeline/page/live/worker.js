// Worker: the solver behind the script of emscripten, one request at a time, called by name.
let solver,
  bodies,
  data,
  pair = null,
  texts = {};

const string = text => {
  const bytes = new TextEncoder().encode(text + '\0'),
    at = solver._malloc(bytes.length);
  solver.HEAPU8.set(bytes, at);
  return at;
};
const read = at => JSON.parse(solver.UTF8ToString(at));

function set(path, value) {
  const a = string(path),
    b = string(value),
    reply = read(solver._explore_set(a, b));
  solver._free(a);
  solver._free(b);
  return reply.error || '';
}

// A compliance as page.cc writes it: head and steps, then what a prediction by harmonic and neighbours has left, byte by byte.
function take(index, is_disc) {
  const at = data.bodies[index],
    doubles = (from, count) => new Float64Array(bodies.slice(from, from + 8 * count).buffer);
  const [n, , harmonics] = doubles(at, 3),
    head = 6 + n,
    steps = doubles(at + 8 * head, 3),
    of = kind => (kind ? n * n : (n * (n + 1)) / 2);
  const count = (harmonics + 2) * (of(0) + 2 * of(1)),
    numbers = new Float64Array(head + count),
    from = at + 8 * (head + 3);
  numbers.set(doubles(at, head));
  const change = new Int32Array(n * n),
    sum = [0, 1, 2].map(() => new Int32Array(n * n));
  for (let m = 0, place = 0; m < harmonics + 2; ++m)
    for (let kind = 0; kind < 3; ++kind)
      for (let j = 0; j < n; ++j)
        for (let i = 0; i < n; ++i) {
          let c;
          if (!kind && i < j) c = change[i * n + j];
          else {
            let z = 0;
            for (let b = 0; b < 4; ++b) z |= bodies[from + b * count + place] << (8 * b);
            const left = (z >>> 1) ^ -(z & 1);
            c =
              (left +
                (i ? change[j * n + i - 1] : 0) +
                (j ? change[(j - 1) * n + i] : 0) -
                (i && j ? change[(j - 1) * n + i - 1] : 0)) |
              0;
          }
          change[j * n + i] = c;
          const whole = (sum[kind][j * n + i] = (sum[kind][j * n + i] + c) | 0);
          if (kind || i >= j) numbers[head + place++] = whole * steps[kind];
        }
  const spot = solver._malloc(numbers.length * 8);
  new Float64Array(solver.HEAPU8.buffer, spot, numbers.length).set(numbers);
  solver._explore_take(spot, is_disc ? 1 : 0);
  solver._free(spot);
}

// The study of a glass on a table, and then what somebody has changed of it.
let changed = {};
function choose(name, changes) {
  const stays = pair === name;
  if (!stays) {
    const chosen = data.pairs[name];
    solver._explore_begin();
    for (const [path, value] of chosen.values) set(path, value);
    take(chosen.foot, false);
    if (chosen.disc !== null) take(chosen.disc, true);
    solver._explore_ready(chosen.fineness);
    pair = name;
    changed = {};
    texts = Object.fromEntries(read(solver._explore_entries()).map(e => [e.path, e.value]));
  }
  const refused = [];
  for (const path in { ...changed, ...changes }) {
    const wish = Object.hasOwn(changes, path) ? changes[path] : texts[path];
    if (stays && changed[path] === changes[path]) continue;
    const why = set(path, wish);
    if (why) refused.push(why);
  }
  changed = refused.length ? {} : { ...changes };
  if (refused.length) pair = null;
  return { refused, stays };
}

const work = {
  solve: m => {
    const { refused, stays } = choose(m.pair, m.changes);
    if (refused.length) return { error: refused[0], refused: true };
    return { ...read(solver._explore_solve(m.harmonics, m.cold || !stays ? 1 : 0)), was_cold: m.cold || !stays };
  },
  curves: () => read(solver._explore_curves()),
  budget: () => read(solver._explore_budget()),
  pressure: () => read(solver._explore_pressure(128)),
  entries: () => read(solver._explore_entries())
};

onmessage = async ({ data: m }) => {
  if (m.wasm) {
    try {
      ({ data, bodies } = m);
      solver = await StemwareSolver({ wasmBinary: m.wasm });
      postMessage({ ready: true });
    } catch (error) {
      postMessage({ lost: String(error) });
    }
    return;
  }
  const start = performance.now();
  let reply;
  try {
    reply = work[m.do](m);
  } catch (error) {
    reply = { error: String(error), lost: true };
    pair = null;
  }
  postMessage({ id: m.id, do: m.do, reply, ms: performance.now() - start });
};
