const $ = id => document.getElementById(id);
const DATA = JSON.parse($('data').textContent), opened = performance.now();
const errors = [];
addEventListener('error', e => errors.push(e.message));
addEventListener('unhandledrejection', e => errors.push(String(e.reason)));

// ---- State: a glass, a table, the number of harmonics, and what has been changed of the study.
const all_harmonics = 17; // the slider's last place
const state = { glass: DATA.glasses[0].name, table: DATA.tables[0].name, harmonics: all_harmonics, changes: {}, language: 'en' };
let answer = null, curves = null, budget = null, pressure = null, measured = null, entries = {}, checked = null;
const T = () => STRINGS[state.language];
const say = (text, ...values) => text.replace(/\{(\d)\}/g, (_, i) => values[i]);
const pair_name = () => state.glass + '|' + state.table, pair = () => DATA.pairs[pair_name()];
const digits = (x, n = 4) => x == null ? '–' : x.toFixed(n).replace('-', '−');
// Decimals as the language has them, in what is read; files have points.
const local = text => state.language === 'en' ? text : text.replace(/(\d)\.(?=\d)/g, '$1,');
const escaped = text => String(text).replace(/[&<>"]/g, c => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);

// Sliders: entry, from, to, step, unit shown, factor of the SI value, logarithmic.
const SLIDERS = [
  ['Motion/Friction coefficient', 0.05, 0.6, 0.01, '', 1],
  ['Motion/Orbit speed', 0.05, 0.6, 0.01, 'm/s', 1],
  ['Motion/Orbit radius', 5, 40, 0.5, 'cm', 100],
  ['Motion/Force offset', -80, 40, 1, 'mm', 1000],
  ['Motion/Mass', 100, 800, 10, 'g', 1000],
  ['Motion/Centre of mass height', 30, 150, 1, 'mm', 1000],
  ['Motion/Grip torque', 0, 3, 0.05, 'mN m', 1000],
  ['Glass/Crown radius', 1, 12, 0.1, 'mm', 1000],
  ['Table/Foundation modulus', 8, 11.5, 0.05, 'Pa/m', 1, true],
  ['Table/Disc Young modulus', 6, 11.5, 0.05, 'Pa', 1, true],
  ['Table/Decay length', -7, -5, 0.05, 'm', 1, true],
];
const base_value = path => entries[path] ? Number(entries[path].value) : 0;
const value_of = path => Object.hasOwn(state.changes, path) ? Number(state.changes[path]) : base_value(path);
const short = x => Number(x.toPrecision(6)).toString();

// ---- The solver: the latest wish is solved, and what is asked after a pause only when there is none.
let worker, busy = true, wish = null, resting = 0, last_id = 0;
const waiting = {};
function post(message) { return new Promise(done => { waiting[++last_id] = done; worker.postMessage({ ...message, id: last_id }); }); }
async function unpack(id) {
  const packed = Uint8Array.from(atob($(id).textContent.trim()), c => c.charCodeAt(0));
  return new Uint8Array(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
}
async function start_solver() {
  const [glue, wasm, bodies] = await Promise.all(['glue', 'wasm', 'bodies'].map(unpack));
  worker = new Worker(URL.createObjectURL(new Blob([glue, '\n', $('worker').textContent], { type: 'text/javascript' })));
  worker.onerror = e => { errors.push('worker: ' + e.message); if (!window.started) lost(e.message || 'Worker'); };
  worker.onmessage = ({ data: m }) => {
    if (m.lost) { lost(m.lost); return; }
    if (m.ready) { window.started = { ready: performance.now() - opened }; begin(); return; }
    waiting[m.id](m); delete waiting[m.id];
  };
  worker.postMessage({ wasm, bodies, data: DATA }, [wasm.buffer, bodies.buffer]);
}
// Without a solver the page has the answer of `stemware run` alone.
function lost(why) {
  errors.push(why);
  const reason = why.length > 100 ? why.slice(0, 100) + '…' : why;
  $('answer').textContent = local(say(T().lost, reason, state.glass, state.table, digits(pair().omega)));
}
const times = [];
async function solve(cold) {
  if (busy) { wish = { cold: cold || (wish && wish.cold) }; return; }
  busy = true; document.body.classList.add('busy');
  clearTimeout(resting);
  const asked = pair_name();
  const slow = setTimeout(() => { $('notice').textContent = T().solving; }, 400);
  const { reply, ms } = await post({ do: 'solve', pair: asked, changes: { ...state.changes }, harmonics: state.harmonics >= all_harmonics ? 0 : state.harmonics, cold });
  times.push({ ms, cold: reply.was_cold, omega: reply.all ? reply.all.omega : null });
  clearTimeout(slow);
  busy = false;
  if (wish) { const next = wish; wish = null; show(reply, ms); return solve(next.cold); }
  document.body.classList.remove('busy');
  show(reply, ms);
  resting = setTimeout(() => rest(reply), 180);
}
async function rest(reply) {
  // After a pause: once more from the beginning, as `stemware run` solves it; then what takes longer.
  if (reply.error || busy) return;
  const still = () => !busy && !wish;
  if (!reply.was_cold) { await solve(true); return; }
  for (const [what, use] of [['curves', r => { curves = r; draw_torque(); draw_spin(); }], ['pressure', r => { pressure = r; draw_pressure(); }], ['budget', r => { budget = r; draw_budget(); facts(times[times.length - 1].ms); }]]) {
    if (!still()) return;
    busy = true;
    const { reply: found } = await post({ do: what });
    busy = false;
    if (wish) { const next = wish; wish = null; solve(next.cold); return; }
    if (!found.error) use(found);
  }
  document.body.dataset.rested = String(times.length);
}

// ---- What it says.
function show(reply, ms) {
  answer = reply.error && !reply.all ? { ...reply, all: null } : reply;
  const box = $('answer'), t = T();
  $('notice').textContent = '';
  box.classList.remove('falls');
  if (!answer.all) {
    curves = budget = pressure = null;
    box.textContent = reply.tips ? t.tips : reply.refused ? say(t.refused, reply.error) : reply.error;
    box.classList.add('falls');
    if (reply.tips) $('notice').textContent = reply.error;
    $('facts').innerHTML = '';
    target = 0;
    draw();
    return;
  }
  const chosen = answer.first_n || answer.all, omega = chosen.omega, all = answer.all;
  if (omega == null) {
    box.textContent = chosen.falls ? local(say(t.falls, digits(chosen.last_spin, 3))) : say(t.no_spin, chosen.reason);
    box.classList.add('falls');
  } else {
    const sense = value_text('Motion/Orbit sense') === 'clockwise' ? -1 : 1;
    const way = Math.abs(omega) < 1e-6 ? t.still : omega * sense < 0 ? t.against : t.along;
    let text = say(t.answer, way, digits(omega), Math.abs(omega) < 1e-6 ? '∞' : (2 * Math.PI / Math.abs(omega)).toFixed(2));
    if (answer.first_n && all.omega != null) {
      const change = all.omega - omega, percent = 100 * (all.omega / omega - 1);
      text += ' ' + say(state.harmonics === 1 ? t.effect_of_first : t.effect, (percent >= 0 ? '+' : '−') + Math.abs(percent).toFixed(2) + ' %', digits(change), state.harmonics);
    } else if (answer.paper.omega != null) text += ' ' + say(t.paper_says, digits(answer.paper.omega));
    const fraction = answer.contact ? answer.contact.contact_fraction : null;
    if (fraction != null) text += ' ' + (fraction < 0.9995 ? say(t.lifts, (100 * fraction).toFixed(0)) : t.full);
    box.textContent = local(text);
  }
  const notes = [...(answer.notes || [])];
  if (answer.fit === 'near') notes.unshift(local(say(t.near, scientific(band()))));
  if (answer.first_n && chosen.standing === 'formal') notes.push(t.pulls);
  $('notice').textContent = notes.join(' ');
  target = omega == null ? chosen.last_spin || 0 : omega;
  target_paper = answer.paper.omega || 0;
  time_constant = all.time_constant || time_constant;
  if (checked === null && answer.was_cold && Object.keys(state.changes).length === 0) {
    const native = pair().omega;
    checked = Math.abs(all.omega - pair().here) < DATA.tolerance;
    $('check').textContent = local(say(checked ? t.check_ok : t.check_bad, digits(all.omega, 10), digits(native, 10)));
    $('check').classList.toggle('falls', !checked);
  }
  facts(ms);
  draw();
}
const band = () => Math.max(DATA.near_band, pair().band || 0);
const value_text = path => Object.hasOwn(state.changes, path) ? state.changes[path] : entries[path] ? entries[path].value : '';
// All harmonics against the first alone, as the budget has them.
function harmonic_effect() {
  const first = budget && budget.rows && budget.rows.find(r => r.harmonics === 1 && r.step >= 3 && r.name !== 'where the foot touches' || r.name === 'tilt'), all = answer.all.omega;
  if (!first || first.omega == null || all == null) return '–';
  const percent = 100 * (all / first.omega - 1);
  return `${percent < 0 ? '−' : '+'}${Math.abs(percent).toFixed(2)} %`;
}
function facts(ms) {
  const f = T().facts, a = answer.all, end = a.at_end || a.at_rest, contact = answer.contact;
  const rows = [[f.omega, digits(a.omega, 6) + ' rad/s'], [f.time_constant, a.time_constant ? a.time_constant.toFixed(3) + ' s' : '–'],
    [f.moment_ratio, end ? end.moment_ratio.toFixed(4) : '–'], [f.fraction, contact ? (100 * contact.contact_fraction).toFixed(1) + ' %' : '–'],
    [f.normal, end ? end.normal_force.toFixed(3) + ' N' : '–'], [f.tau0, a.at_rest ? digits(1e3 * a.at_rest.torque) + ' mN m' : '…'],
    [f.lean, contact ? (1e6 * Math.hypot(contact.motion[1], contact.motion[2])).toFixed(1) + ' µrad' : '–'],
    [f.effect, harmonic_effect()], [f.band, pair().band || answer.fit === 'near' ? '±' + scientific(band()) + ' rad/s' : '–'], [f.ms, ms.toFixed(0) + ' ms']];
  $('facts').innerHTML = rows.map(([k, v]) => `<div><dt>${escaped(k)}</dt><dd>${escaped(local(v))}</dd></div>`).join('');
}

// ---- Controls.
function chips(box, list, kind) {
  $(box).innerHTML = '';
  for (const { name, words } of list) {
    const button = document.createElement('button');
    button.textContent = name; button.title = words; button.dataset.name = name;
    button.setAttribute('aria-pressed', state[kind] === name);
    button.onclick = () => { if (state[kind] === name) return; drop_changes(list, state[kind], name); state[kind] = name; choose(); };
    $(box).append(button);
  }
}
// What a glass or table brings along replaces what was changed of it.
function drop_changes(list, ...names) {
  for (const { name, sets } of list) if (names.includes(name)) for (const path of sets) delete state.changes[path];
}
function choose() {
  for (const box of ['glasses', 'tables']) for (const b of $(box).children) b.setAttribute('aria-pressed', b.dataset.name === (box === 'glasses' ? state.glass : state.table));
  curves = budget = pressure = null;
  load_entries();
  make_sliders();
  remember();
  solve(true);
}
// The values of the pair's study, without changes.
function load_entries() {
  entries = {};
  for (const path in DATA.entries) entries[path] = { value: DATA.entries[path], acts: pair().acts.includes(path) };
  for (const [path, value] of pair().values) entries[path].value = value;
}
function make_sliders() {
  const box = $('sliders'); box.innerHTML = '';
  for (const [path, from, to, step, unit, factor, log] of SLIDERS) {
    if (!entries[path] || !entries[path].acts) continue;
    const id = path.replace(/\W/g, '-'), slider = document.createElement('div');
    slider.className = 'slider';
    slider.innerHTML = `<label for="${id}">${escaped(T().labels[path] || path.split('/')[1])}</label><output for="${id}"></output><input type="range" id="${id}" step="${step}">`;
    const input = slider.querySelector('input'), shown = value => log ? Math.log10(value) : value * factor;
    const now = shown(value_of(path)), base = shown(base_value(path));
    input.min = Math.min(from, base); input.max = Math.max(to, base); input.value = now; input.dataset.path = path;
    const write = () => {
      const value = value_of(path);
      slider.querySelector('output').textContent = local((log ? scientific(value) : Number((value * factor).toFixed(3)).toString().replace('-', '−')) + (unit ? ' ' + unit : ''));
      input.setAttribute('aria-valuetext', slider.querySelector('output').textContent);
      slider.classList.toggle('changed', Object.hasOwn(state.changes, path));
    };
    input.oninput = () => {
      const raw = Number(input.value), value = log ? 10 ** raw : raw / factor;
      if (Math.abs(raw - base) < Number(step) / 2 && !log || Math.abs(raw - base) < 1e-9) delete state.changes[path]; else state.changes[path] = short(value);
      write(); remember(); solve(false);
    };
    slider.querySelector('label').ondblclick = () => { delete state.changes[path]; input.value = base; write(); remember(); solve(false); };
    write();
    box.append(slider);
  }
}
const scientific = x => { const n = Math.floor(Math.log10(x) + 1e-9); return `${(x / 10 ** n).toFixed(2)}·10${String(n).replace(/[-\d]/g, c => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(c)])}`; };
function write_harmonics() {
  const t = T(), n = state.harmonics;
  $('harmonics-out').textContent = n >= all_harmonics ? t.all : say(t.first, n);
  $('harmonics').setAttribute('aria-valuetext', $('harmonics-out').textContent);
  $('harmonics').value = n;
}

// ---- The address.
function remember() {
  const parts = { glass: state.glass, table: state.table, ...state.changes };
  if (state.harmonics < all_harmonics) parts.harmonics = state.harmonics;
  if (state.language !== 'en') parts.language = state.language;
  try { history.replaceState(null, '', '#' + new URLSearchParams(parts)); } catch { location.hash = '#' + new URLSearchParams(parts); }
}
function recall() {
  for (const [key, value] of new URLSearchParams(location.hash.slice(1))) {
    if (key === 'glass' && DATA.glasses.some(g => g.name === value)) state.glass = value;
    else if (key === 'table' && DATA.tables.some(g => g.name === value)) state.table = value;
    else if (key === 'harmonics') state.harmonics = Math.min(Math.max(1, Math.round(Number(value)) || 1), all_harmonics);
    else if (key === 'language' && Object.hasOwn(STRINGS, value)) state.language = value;
    else if (key.includes('/')) state.changes[key] = value;
  }
}

// ---- Pictures. Lines, axes and words of a plot are made here alone.
const COLOURS = ['var(--all)', 'var(--first)', 'var(--paper)', 'var(--ink)'];
function ticks(from, to, n) {
  const raw = (to - from) / n, power = 10 ** Math.floor(Math.log10(raw)), step = [1, 2, 5, 10].map(s => s * power).find(s => s >= raw) || raw, list = [];
  for (let x = Math.ceil(from / step - 1e-9) * step; x <= to + 1e-9 * step; x += step) list.push(Math.abs(x) < 1e-12 * step ? 0 : x);
  return list;
}
const tick_text = x => Number(x.toPrecision(6)).toString().replace('-', '−');
// Names of curves in rows beside the label of the axis: their marks, and how many rows there are.
const ruler = document.createElement('canvas').getContext('2d');
ruler.font = '12px system-ui, sans-serif';
function legend(series, begin, end) {
  let x = begin, row = 0, svg = '';
  for (const s of series.filter(s => s.name)) {
    const width = 34 + ruler.measureText(s.name).width;
    if (x > begin && x + width > end) { x = begin; ++row; }
    const y = 12 + 16 * row;
    svg += s.points ? `<circle cx="${x + 8}" cy="${y}" r="2.4" fill="${s.colour}"/>` : `<path d="M${x} ${y}h16" stroke="${s.colour}" stroke-width="2.5" ${s.dash ? `stroke-dasharray="${s.dash}"` : ''}/>`;
    svg += `<text x="${x + 20}" y="${y + 4}">${escaped(s.name)}</text>`;
    x += width;
  }
  return { svg, rows: row + 1 };
}
function plot(id, { x_label, y_label, series, x_range, zero, x_ticks, marks = [] }) {
  const shown = series.filter(s => s.y && s.y.some(Number.isFinite));
  const xs = x_range || [Math.min(...shown.flatMap(s => s.x)), Math.max(...shown.flatMap(s => s.x))];
  const values = shown.flatMap(s => s.y).filter(Number.isFinite);
  if (!values.length) { blank(id); return; }
  const W = 380, H = 240, left = 52, right = 10, bottom = 38, names = legend(shown, Math.max(left + 8, 18 + ruler.measureText(y_label).width), W), top = 10 + 16 * names.rows;
  let low = Math.min(...values), high = Math.max(...values);
  if (zero) { low = Math.min(low, 0); high = Math.max(high, 0); }
  if (high - low < 1e-12 * Math.max(1, Math.abs(high))) { low -= 0.5; high += 0.5; }
  const room = 0.05 * (high - low); if (low !== 0 || !zero) low -= room; if (high !== 0 || !zero) high += room;
  const X = x => left + (W - left - right) * (x - xs[0]) / (xs[1] - xs[0]), Y = y => H - bottom - (H - top - bottom) * (y - low) / (high - low);
  let svg = '';
  for (const y of ticks(low, high, 5)) svg += `<path d="M${left} ${Y(y).toFixed(1)}H${W - right}" stroke="var(--grid)"/><text class="quiet" x="${left - 6}" y="${(Y(y) + 4).toFixed(1)}" text-anchor="end">${tick_text(y)}</text>`;
  for (const x of x_ticks || ticks(...xs, 6)) svg += `<text class="quiet" x="${X(x).toFixed(1)}" y="${H - bottom + 16}" text-anchor="middle">${tick_text(x)}</text>`;
  svg += `<path d="M${left} ${top}V${H - bottom}H${W - right}" fill="none" stroke="var(--line)"/>`;
  if (low < 0 && high > 0) svg += `<path d="M${left} ${Y(0).toFixed(1)}H${W - right}" stroke="var(--quiet)"/>`;
  shown.forEach(s => {
    let pen = false, d = '';
    s.x.forEach((x, i) => { const y = s.y[i]; if (!Number.isFinite(y)) { pen = false; return; } if (s.points) return; d += `${pen ? 'L' : 'M'}${X(x).toFixed(1)} ${Y(y).toFixed(1)}`; pen = true; });
    if (s.points) s.x.forEach((x, i) => { if (x >= xs[0] && x <= xs[1] && Number.isFinite(s.y[i])) svg += `<circle cx="${X(x).toFixed(1)}" cy="${Y(s.y[i]).toFixed(1)}" r="2.4" fill="${s.colour}"/>`; });
    else svg += `<path d="${d}" fill="none" stroke="${s.colour}" stroke-width="${s.width || 2}" ${s.dash ? `stroke-dasharray="${s.dash}"` : ''} stroke-linejoin="round"/>`;
  });
  for (const m of marks) if (m.x >= xs[0] && m.x <= xs[1]) svg += `<circle cx="${X(m.x).toFixed(1)}" cy="${Y(m.y || 0).toFixed(1)}" r="4" fill="${m.colour}"/>`;
  svg += names.svg + `<text class="quiet" x="${W - right}" y="${H - 4}" text-anchor="end">${escaped(x_label)}</text><text class="quiet" x="2" y="16">${escaped(y_label)}</text>`;
  picture(id, `0 0 ${W} ${H}`, svg, ['curve', x_label, y_label], shown.flatMap(s => s.x.map((x, i) => [s.name || id, x, s.y[i]])));
}
const tables = {};
// In the place of a picture that there is not, or not yet.
function blank(id) {
  $(id).innerHTML = `<p class="quiet">${escaped(busy ? T().solving : answer && !answer.all ? T().nothing : T().budget_wait)}</p>`;
  delete tables[id];
}
// Shows a picture; its CSV has one heading line and a row for each point.
function picture(id, box, inside, heading, rows) {
  const plot = $(id), title = plot.closest('section').querySelector('h2').textContent;
  if (!plot.querySelector('svg')) plot.innerHTML = `<svg role="img"></svg><span class="save print-no"><button data-as="svg">SVG</button><button data-as="png">PNG</button><button data-as="csv">CSV</button></span>`;
  const svg = plot.querySelector('svg');
  svg.setAttribute('viewBox', box); svg.setAttribute('aria-label', title);
  svg.innerHTML = inside.replace(/>([^<]*)<\/text>/g, (_, words) => `>${local(words)}</text>`);
  for (const b of plot.querySelectorAll('.save button')) { b.setAttribute('aria-label', `${title}: ${b.dataset.as.toUpperCase()}`); b.onclick = () => save_picture(id, b.dataset.as); }
  tables[id] = { heading, rows };
}
// Curves, budget and pressure stay those of the last pause while something moves.
function draw() {
  draw_load(); draw_side(); draw_scene_parts();
  if (answer.all && !answer.was_cold) return;
  draw_torque(); draw_spin(); draw_budget(); draw_pressure();
}

// The load at theta of an end state, up to harmonic n.
const load_at = (s, theta, n = 1e9) => { let sum = 0; for (let k = 0; k < s.a.length && k <= n; ++k) sum += s.a[k] * Math.cos(k * theta) + s.b[k] * Math.sin(k * theta); return sum; };
const angles = Array.from({ length: 361 }, (_, i) => i - 180);
function smooth_load(n) { // of all harmonics the pointwise load, which has no waves where the rim is lifted
  const c = answer.contact;
  if (n === undefined && c && c.azimuth.length) {
    const order = c.azimuth.map((a, i) => [(a > Math.PI ? a - 2 * Math.PI : a) * 180 / Math.PI, c.load[i]]).sort((a, b) => a[0] - b[0]);
    return { x: order.map(o => o[0]), y: order.map(o => o[1]) };
  }
  return { x: angles, y: angles.map(d => load_at(answer.all.at_end || answer.all.at_rest, d * Math.PI / 180, n)) };
}
function draw_load() {
  const t = T(), t_n = state.harmonics;
  if (!answer || !answer.all || !(answer.all.at_end || answer.all.at_rest)) { plot('load', { series: [] }); return; }
  const list = [{ ...smooth_load(), name: t.all, colour: COLOURS[0] }];
  const cut = answer.first_n && (answer.first_n.at_end || answer.first_n.at_rest);
  if (cut) list.push({ x: angles, y: angles.map(d => load_at(cut, d * Math.PI / 180, t_n)), name: say(t.first, t_n), colour: COLOURS[1] });
  const paper = answer.paper.at_end;
  if (paper) list.push({ x: angles, y: angles.map(d => load_at(paper, d * Math.PI / 180)), name: t.paper, colour: COLOURS[2], dash: '5 4' });
  plot('load', { x_label: t.theta, y_label: t.load_axis, series: list, x_range: [-180, 180], zero: true, x_ticks: [-180, -90, 0, 90, 180] });
}
const numbers = list => list ? list.map(v => v == null ? NaN : v) : null;
function draw_torque() {
  const t = T(); if (!curves || !curves.spin) { plot('torque', { series: [] }); return; }
  const scaled = list => list ? numbers(list).map(v => 1e3 * v) : null;
  plot('torque', { x_label: t.omega_axis, y_label: t.torque_axis, zero: true, series: [
    { x: curves.spin, y: scaled(curves.of_paper), name: t.paper, colour: COLOURS[2], dash: '5 4' },
    { x: curves.spin, y: scaled(curves.torque), name: t.all, colour: COLOURS[0] },
    { x: curves.spin, y: scaled(curves.of_n), name: say(t.first, state.harmonics), colour: COLOURS[1] }].filter(s => s.y),
    marks: !answer.all ? [] : [[answer.paper, COLOURS[2]], [answer.all, COLOURS[0]], [answer.first_n, COLOURS[1]]].filter(([row]) => row && row.omega != null).map(([row, colour]) => ({ x: row.omega, y: 0, colour })) });
}
function draw_spin() {
  const t = T(); if (!curves || !curves.time) { plot('spin', { series: [] }); return; }
  const list = [{ x: curves.time, y: numbers(curves.omega_paper), name: t.paper, colour: COLOURS[2], dash: '5 4' }, { x: curves.time, y: numbers(curves.omega), name: t.all, colour: COLOURS[0] }];
  if (curves.omega_n.length) list.push({ x: curves.time, y: numbers(curves.omega_n), name: say(t.first, state.harmonics), colour: COLOURS[1] });
  if (measured) list.push({ ...measured, name: t.measured, colour: COLOURS[3], points: true });
  plot('spin', { x_label: t.time, y_label: t.omega_axis, series: list, x_range: [0, curves.time[curves.time.length - 1]], zero: true });
}
function draw_budget() {
  const t = T(), rows = budget && budget.rows ? budget.rows.filter(r => r.omega != null) : [];
  if (!rows.length) { blank('budget'); return; }
  const shown = rows.filter((r, i) => i === 0 || Math.abs(r.difference || 0) > 1e-6), W = 380, row = 24, top = 8, left = 128, H = top + row * (shown.length + 1) + 26;
  const values = shown.flatMap((r, i) => i ? [r.omega, r.omega - r.difference] : [r.omega]), low = Math.min(...values), high = Math.max(...values), room = 0.12 * (high - low || 1);
  const X = v => left + (W - left - 62) * (v - low + room) / (high - low + 2 * room);
  let svg = '';
  for (const v of ticks(low, high, 3)) svg += `<path d="M${X(v).toFixed(1)} ${top}V${H - 24}" stroke="var(--grid)"/><text class="quiet" x="${X(v).toFixed(1)}" y="${H - 10}" text-anchor="middle">${tick_text(v)}</text>`;
  shown.forEach((r, i) => {
    const y = top + row * i, name = r.name === 'harmonics' && r.harmonics ? `n ≤ ${r.harmonics}` : t.steps[r.name] || r.name, label = i && r.name === 'harmonics' && !r.harmonics ? t.all : name;
    svg += `<text x="${left - 8}" y="${y + 16}" text-anchor="end">${escaped(label)}</text>`;
    if (i === 0) svg += `<circle cx="${X(r.omega).toFixed(1)}" cy="${y + 11}" r="4" fill="var(--paper)"/><text x="${(X(r.omega) + 8).toFixed(1)}" y="${y + 15}">${digits(r.omega)}</text>`;
    else {
      const a = X(r.omega - r.difference), b = X(r.omega), right = Math.max(a, b);
      svg += `<rect x="${Math.min(a, b).toFixed(1)}" y="${y + 4}" width="${Math.max(1, Math.abs(b - a)).toFixed(1)}" height="14" rx="2" fill="${r.difference < 0 ? 'var(--all)' : 'var(--first)'}"/><path d="M${a.toFixed(1)} ${y - 6}v10" stroke="var(--quiet)"/><text x="${(right + 5).toFixed(1)}" y="${y + 15}">${r.difference > 0 ? '+' : '−'}${Math.abs(r.difference).toPrecision(2)}</text>`;
    }
  });
  const end = rows[rows.length - 1], y = top + row * shown.length;
  svg += `<circle cx="${X(end.omega).toFixed(1)}" cy="${y + 11}" r="4" fill="var(--all)"/><text x="${left - 8}" y="${y + 16}" text-anchor="end">=</text><text x="${(X(end.omega) + 8).toFixed(1)}" y="${y + 15}">${digits(end.omega)}</text>`;
  picture('budget', `0 0 ${W} ${H}`, svg + `<text class="quiet" x="${W - 2}" y="${H - 10}" text-anchor="end">rad/s</text>`, ['model', 'harmonics', 'omega (rad/s)'], rows.map(r => [r.name, r.harmonics || '', r.omega]));
}
// Pale to dark: a load of none is the ground.
const shade = x => `color-mix(in srgb, var(--all) ${(100 * Math.max(0, Math.min(1, x))).toFixed(0)}%, var(--glass))`;
function draw_pressure() {
  const t = T(); if (!pressure || !pressure.cuts || !pressure.cuts.length || !answer || !answer.contact) { blank('pressure'); return; }
  const W = 380, H = 240, left = 46, right = 10, top = 26, bottom = 38, c = answer.contact;
  const middle = (c.inner_radius + c.outer_radius) / 2, half = Math.max(0.75 * (c.outer_radius - c.inner_radius), 1e-6), r0 = middle - half, r1 = middle + half, N = 40;
  let most = 0; const grid = pressure.cuts.map(([radii, values]) => Array.from({ length: N }, (_, k) => {
    const r = r0 + (r1 - r0) * (k + 0.5) / N; let i = radii.findIndex(x => x > r);
    const p = i <= 0 ? 0 : values[i - 1] + (values[i] - values[i - 1]) * (r - radii[i - 1]) / (radii[i] - radii[i - 1]);
    most = Math.max(most, p); return p; }));
  const w = (W - left - right) / grid.length, h = (H - top - bottom) / N;
  let svg = `<rect x="${left}" y="${top}" width="${W - left - right}" height="${H - top - bottom}" fill="var(--glass)"/>`;
  grid.forEach((cut, j) => { const degrees = ((pressure.azimuth[j] * 180 / Math.PI + 540) % 360) - 180, x = left + (W - left - right) * (degrees + 180) / 360;
    cut.forEach((p, k) => { if (p > 1e-3 * most) svg += `<rect x="${x.toFixed(1)}" y="${(H - bottom - h * (k + 1)).toFixed(1)}" width="${(w + 0.4).toFixed(1)}" height="${(h + 0.4).toFixed(1)}" fill="${shade(p / most)}"/>`; }); });
  for (const x of [-180, -90, 0, 90, 180]) svg += `<text class="quiet" x="${(left + (W - left - right) * (x + 180) / 360).toFixed(1)}" y="${H - bottom + 16}" text-anchor="middle">${tick_text(x)}</text>`;
  for (const r of ticks(1e3 * r0, 1e3 * r1, 4)) svg += `<text class="quiet" x="${left - 5}" y="${(H - bottom - (H - top - bottom) * (r / 1e3 - r0) / (r1 - r0) + 4).toFixed(1)}" text-anchor="end">${tick_text(r)}</text>`;
  svg += `<text class="quiet" x="2" y="14">${escaped(t.radius)}</text><text x="${W - right}" y="14" text-anchor="end">≤ ${most >= 1e6 ? (most / 1e6).toPrecision(3) + ' MPa' : (most / 1e3).toPrecision(3) + ' kPa'}</text><text class="quiet" x="${W - right}" y="${H - 4}" text-anchor="end">${escaped(t.theta)}</text>`;
  picture('pressure', `0 0 ${W} ${H}`, svg, ['theta (rad)', 'r (m)', 'p (Pa)'],
    pressure.cuts.flatMap(([radii, values], j) => radii.map((r, i) => [pressure.azimuth[j], r, values[i]])));
}
function draw_side() {
  const t = T(), W = 380, H = 300, ground = 262, mm = v => 1e3 * v, middle = 190;
  const R = mm(value_of('Glass/Contact radius')), z = mm(value_of('Motion/Centre of mass height')), hand = z + mm(value_of('Motion/Force offset')), mass = value_of('Motion/Mass'), N = mass * 9.81;
  const foot = mm(value_of('Glass/Foot radius')) || R + 4, top = Math.max(z * 1.9, 110), bowl = foot * 0.95, scale = Math.min(1.5, (ground - 24) / top);
  const X = x => middle + scale * x, Y = y => ground - scale * y;
  const end = answer && answer.all ? answer.all.at_end || answer.all.at_rest : null;
  const said = [[t.mass_centre, z, 'mm']];
  const arrow = (x, y, dx, dy, colour, text, anchor = 'start') => { const n = Math.hypot(dx, dy) || 1, u = dx / n, v = dy / n, ex = x + dx, ey = y + dy; return n < 2 ? '' : `<path d="M${x.toFixed(1)} ${y.toFixed(1)}L${ex.toFixed(1)} ${ey.toFixed(1)}M${(ex - 7 * u + 4 * v).toFixed(1)} ${(ey - 7 * v - 4 * u).toFixed(1)}L${ex.toFixed(1)} ${ey.toFixed(1)}L${(ex - 7 * u - 4 * v).toFixed(1)} ${(ey - 7 * v + 4 * u).toFixed(1)}" fill="none" stroke="${colour}" stroke-width="2"/><text x="${(ex + (anchor === 'end' ? -6 : 6)).toFixed(1)}" y="${(ey + 4).toFixed(1)}" text-anchor="${anchor}">${escaped(text)}</text>`; };
  const lean = answer && answer.contact ? -answer.contact.motion[1] * 180 / Math.PI : 0;
  let svg = `<path d="M10 ${ground}H${W - 10}" stroke="var(--ink)" stroke-width="1.5"/>`;
  svg += `<g transform="rotate(${(answer && !answer.all && answer.tips ? 14 : lean).toFixed(5)} ${middle + scale * R} ${ground})"><path d="M${X(-foot)} ${ground}Q${X(-foot)} ${Y(3)} ${X(-5)} ${Y(6)}V${Y(top * 0.45)}Q${X(-bowl)} ${Y(top * 0.55)} ${X(-bowl * 0.8)} ${Y(top)}H${X(bowl * 0.8)}Q${X(bowl)} ${Y(top * 0.55)} ${X(5)} ${Y(top * 0.45)}V${Y(6)}Q${X(foot)} ${Y(3)} ${X(foot)} ${ground}Z" fill="var(--glass)" stroke="var(--line)" stroke-width="1.5"/><circle cx="${middle}" cy="${Y(z)}" r="4.5" fill="var(--ink)"/></g>`;
  svg += `<text class="quiet" x="${middle + (answer && !answer.all && answer.tips ? 28 : 9)}" y="${Y(z) + 4}">${escaped(t.mass_centre)} ${tick_text(Math.round(z))} mm</text>`;
  if (end) {
    const v = value_of('Motion/Orbit speed'), rho = value_of('Motion/Orbit radius'), per = 22, fx = -end.friction[0];
    svg += arrow(middle, Y(hand), per * fx, 0, 'var(--first)', `${t.hand} ${fx.toFixed(2)} N`);
    svg += arrow(X(R * 0.2), ground + 16, per * end.friction[0], 0, 'var(--all)', `${t.fric} ${Math.abs(end.friction[0]).toFixed(2)} N`, 'end');
    const lever = end.moment ? end.moment[1] / -end.normal_force * 1e3 : 0;
    svg += arrow(X(lever), ground + 36, 0, -36, 'var(--all)', '') + `<text x="${X(lever) + 8}" y="${ground + 34}">N = ${N.toFixed(2)} N, ${tick_text(Number(lever.toFixed(1)))} mm</text>`;
    said.push([t.hand, fx, 'N'], [t.fric, Math.abs(end.friction[0]), 'N'], ['N', N, 'N'], ['M_N/N', lever, 'mm'], ['v', v, 'm/s'], ['v²/ρ', v * v / rho, 'm/s²']);
    svg += `<text class="quiet" x="${W - 10}" y="16" text-anchor="end">v = ${v} m/s, v²/ρ = ${(v * v / rho).toFixed(2)} m/s²</text>`;
  }
  picture('side', `0 0 ${W} ${H}`, svg, ['quantity', 'value', 'unit'], said);
}

// ---- From above: two orbits, elastic foot and paper's ring, in real time.
let target = 0, target_paper = 0, time_constant = 0.3, omega = 0, omega_paper = 0, psi = 0, psi_paper = 0, phi = Math.PI / 2, held = false;
if (matchMedia('(prefers-reduced-motion: reduce)').matches) held = true;
const NS = 'http://www.w3.org/2000/svg', scene_parts = [];
const sense = () => value_text('Motion/Orbit sense') === 'clockwise' ? -1 : 1;
const arcs = 72, n_arrows = 12;
function draw_scene_parts() {
  const svg = $('scene'), t = T();
  if (!scene_parts.length) {
    for (const [i, x] of [[0, 160], [1, 480]]) {
      const g = document.createElementNS(NS, 'g'); g.setAttribute('transform', `translate(${x} 150)`);
      g.innerHTML = `<circle r="96" fill="none" stroke="var(--line)" stroke-dasharray="3 4"/><circle r="2.5" fill="var(--quiet)"/><path class="hand" stroke="var(--quiet)" stroke-width="1.2"/><g class="glass"><circle class="body" r="46" fill="var(--card)" stroke="var(--line)"/><g class="rim"></g><path class="mark" d="M0 0L30 0M24 -4L32 0L24 4" stroke="var(--ink)" stroke-width="2.5" fill="none"/><circle r="3" fill="var(--ink)"/><g class="arrows"></g></g><text text-anchor="middle" y="166" class="name"></text>`;
      svg.append(g); scene_parts.push(g);
    }
  }
  [[t.elastic, answer && answer.all ? answer.first_n || answer.all : null, 0], [t.ring, answer && answer.all ? answer.paper : null, 1]].forEach(([name, row, i]) => {
    const g = scene_parts[i], s = row && (row.at_end || row.at_rest);
    g.querySelector('.name').textContent = local(name + (row && row.omega != null ? `: ${digits(row.omega, 3)} rad/s` : ''));
    g.loads = s ? Array.from({ length: arcs }, (_, k) => { const th = 2 * Math.PI * (k + 0.5) / arcs; return i === 0 && row === answer.all ? pointwise(th) : load_at(s, th, row === answer.first_n ? state.harmonics : 1e9); }) : null;
    const most = g.loads ? Math.max(...g.loads) : 1;
    g.querySelector('.rim').innerHTML = g.loads ? g.loads.map((v, k) => { const a = 2 * Math.PI * k / arcs, b = 2 * Math.PI * (k + 1.05) / arcs, r = 40; return `<path d="M${(r * Math.cos(a)).toFixed(2)} ${(-r * Math.sin(a)).toFixed(2)}A${r} ${r} 0 0 0 ${(r * Math.cos(b)).toFixed(2)} ${(-r * Math.sin(b)).toFixed(2)}" fill="none" stroke="${v < 0 ? 'var(--first)' : v < 1e-6 * most ? 'var(--line)' : shade(0.12 + 0.88 * v / most)}" stroke-width="${v <= 1e-6 * most ? 2 : 9}"/>`; }).join('') : '';
    g.most = most;
  });
}
function pointwise(theta) {
  const c = answer.contact; if (!c || !c.azimuth.length) return load_at(answer.all.at_end || answer.all.at_rest, theta);
  let best = 0, least = 9; c.azimuth.forEach((a, i) => { const d = Math.abs(((a - theta + 3 * Math.PI) % (2 * Math.PI)) - Math.PI); if (d < least) { least = d; best = i; } });
  return c.load[best];
}
function place(g, spin, yaw) {
  const s = sense(), x = 96 * Math.cos(phi), y = -96 * Math.sin(phi), heading = phi + s * Math.PI / 2, v = value_of('Motion/Orbit speed') || 0.3, R = value_of('Glass/Contact radius') || 0.03;
  g.querySelector('.hand').setAttribute('d', `M0 0L${x.toFixed(2)} ${y.toFixed(2)}`);
  g.querySelector('.glass').setAttribute('transform', `translate(${x.toFixed(2)} ${y.toFixed(2)})`);
  const turn = -heading * 180 / Math.PI;
  g.querySelector('.rim').setAttribute('transform', `rotate(${turn.toFixed(2)})`);
  g.querySelector('.mark').setAttribute('transform', `rotate(${(-yaw * 180 / Math.PI).toFixed(2)})`);
  const box = g.querySelector('.arrows'); box.setAttribute('transform', `rotate(${turn.toFixed(2)})`);
  if (!g.loads) { box.innerHTML = ''; return; }
  let d = '';
  for (let k = 0; k < n_arrows; ++k) {
    const th = 2 * Math.PI * k / n_arrows, load = g.loads[Math.floor(k * arcs / n_arrows)]; if (load <= 0) continue;
    const vx = v - spin * R * Math.sin(th), vy = spin * R * Math.cos(th), n = Math.hypot(vx, vy) || 1, long = 26 * load / g.most, px = 51 * Math.cos(th), py = 51 * Math.sin(th), ux = -vx / n, uy = -vy / n, ex = px + long * ux, ey = py + long * uy;
    if (long < 2) continue;
    d += `M${px.toFixed(1)} ${(-py).toFixed(1)}L${ex.toFixed(1)} ${(-ey).toFixed(1)}M${(ex - 5 * ux + 3 * uy).toFixed(1)} ${(-(ey - 5 * uy - 3 * ux)).toFixed(1)}L${ex.toFixed(1)} ${(-ey).toFixed(1)}L${(ex - 5 * ux - 3 * uy).toFixed(1)} ${(-(ey - 5 * uy + 3 * ux)).toFixed(1)}`;
  }
  box.innerHTML = `<path d="${d}" fill="none" stroke="var(--first)" stroke-width="1.6"/>`;
}
let before = performance.now();
function frame(now) {
  const dt = held ? 0 : Math.min(0.05, (now - before) / 1000); before = now;
  const rate = 1 - Math.exp(-dt / Math.max(0.02, time_constant));
  omega += (target - omega) * rate; omega_paper += (target_paper - omega_paper) * rate;
  psi += omega * dt; psi_paper += omega_paper * dt;
  phi += sense() * (value_of('Motion/Orbit speed') || 0) / (value_of('Motion/Orbit radius') || 1) * dt;
  if (scene_parts.length) { place(scene_parts[0], omega, psi); place(scene_parts[1], omega_paper, psi_paper); }
  requestAnimationFrame(frame);
}

// ---- Take along.
function download(name, type, content) { const a = document.createElement('a'); a.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type })); a.download = name; a.click(); setTimeout(() => URL.revokeObjectURL(a.href), 1000); }
const cell = x => (/[",\n]/.test(x) ? `"${String(x).replace(/"/g, '""')}"` : `${x}`);
const csv_of = ({ heading, rows }) => [heading, ...rows].map(row => row.map(cell).join(',') + '\n').join('');
// Points of all curves: which picture and curve, what x and y are, and x and y.
const all_curves = () => ({ heading: ['picture', 'curve', 'x is', 'y is', 'x', 'y'],
  rows: Object.entries(tables).filter(([, t]) => t.heading[0] === 'curve').flatMap(([id, t]) => t.rows.map(([curve, x, y]) => [id, curve, t.heading[1], t.heading[2], x, y])) });
function standalone(id) {
  const svg = $(id).querySelector('svg').cloneNode(true), style = getComputedStyle(document.documentElement);
  svg.setAttribute('xmlns', NS); const box = svg.getAttribute('viewBox').split(' ').map(Number); svg.setAttribute('width', box[2]); svg.setAttribute('height', box[3]);
  let text = new XMLSerializer().serializeToString(svg).replace('>', `><style>text{font:12px sans-serif;fill:${style.getPropertyValue('--ink')}}text.quiet{fill:${style.getPropertyValue('--quiet')}}</style><rect width="100%" height="100%" fill="${style.getPropertyValue('--card')}"/>`);
  // Colours that were mixed by the browser stand in other programs as they are.
  const probe = document.createElement('span'); document.body.append(probe);
  const fixed = {}; text = text.replace(/(color-mix\([^"]*?\)\)|color-mix\(in srgb, var\([^)]*\) \d+%, var\([^)]*\)\)|var\(--[a-z-]+\))/g, m => { if (!fixed[m]) { probe.style.color = ''; probe.style.color = m; fixed[m] = getComputedStyle(probe).color.replace(/color\(srgb ([\d.]+) ([\d.]+) ([\d.]+)\)/, (_, r, g, b) => `rgb(${[r, g, b].map(v => Math.round(255 * v)).join(',')})`); } return fixed[m]; });
  probe.remove();
  return { text, width: box[2], height: box[3] };
}
function save_picture(id, as) {
  if (as === 'csv') return download(id + '.csv', 'text/csv', csv_of(tables[id]));
  const { text, width, height } = standalone(id);
  if (as === 'svg') return download(id + '.svg', 'image/svg+xml', text);
  const image = new Image(), factor = 3;
  image.onload = () => { const canvas = document.createElement('canvas'); canvas.width = factor * width; canvas.height = factor * height; const pen = canvas.getContext('2d'); pen.drawImage(image, 0, 0, canvas.width, canvas.height); canvas.toBlob(blob => download(id + '.png', 'image/png', blob)); };
  image.src = 'data:image/svg+xml;charset=utf-8,' + encodeURIComponent(text);
}
function study_text() {
  const values = { ...Object.fromEntries(pair().values), ...state.changes }, sections = new Map();
  const line = words => words.replace(/[\r\n]+/g, ' ');
  for (const path in values) {
    const [section, ...name] = path.split('/').map(line);
    sections.set(section, [...sections.get(section) || [], `  set ${name.join('/')} = ${line(values[path])}`]);
  }
  let text = `# ${state.glass} on ${state.table}, from the page of Stemware ${DATA.version}\n#\n#   stemware run explored.prm\n`;
  if (answer && answer.all && answer.all.omega != null) text += `#\n# The page's terminal spin: ${answer.all.omega} rad/s\n`;
  for (const [section, lines] of sections) text += `\nsubsection ${section}\n${lines.join('\n')}\nend\n`;
  return text;
}
// Rows of time and spin, or time and angle (a head that says angle, psi or deg); decimals by point, or by comma where columns are by semicolon.
function read_measured(text) {
  const lines = text.split(/\r?\n/).map(l => l.trim()).filter(l => l && !l.startsWith('#')), head = lines.find(l => /[a-z]/i.test(l.replace(/e[-+]?\d/gi, ''))) || '';
  const rows = lines.map(l => (l.includes(';') ? l.replace(/,/g, '.').split(';') : l.split(/[,\t ]+/)).map(Number)).filter(r => r.length >= 2 && r.slice(0, 2).every(Number.isFinite));
  if (rows.length < 2) return null;
  const factor = /deg|°/i.test(head) ? Math.PI / 180 : /rpm|1\/min/i.test(head) ? Math.PI / 30 : 1, x = rows.map(r => r[0]), y = rows.map(r => r[1] * factor);
  if (!/angle|psi|winkel|ψ/i.test(head)) return { x, y };
  const mid = [], rate = []; for (let i = 1; i < x.length; ++i) if (x[i] > x[i - 1]) { mid.push((x[i] + x[i - 1]) / 2); rate.push((y[i] - y[i - 1]) / (x[i] - x[i - 1])); }
  return { x: mid, y: rate };
}
async function take_file(file) { if (!file) return; const found = read_measured(await file.text()); if (found) { measured = found; draw_spin(); } else $('notice').textContent = T().drop; }

// ---- Beginning.
function speak() {
  document.documentElement.lang = state.language;
  for (const e of document.querySelectorAll('[data-t]')) e.textContent = T()[e.dataset.t];
  document.title = T().title;
  document.querySelector('main').hidden = false;
  $('languages').innerHTML = '';
  for (const code in STRINGS) { const b = document.createElement('button'); b.textContent = STRINGS[code].name; b.lang = code; b.setAttribute('aria-pressed', code === state.language); b.onclick = () => { state.language = code; remember(); speak(); make_sliders(); if (answer) show(answer, times.length ? times[times.length - 1].ms : 0); }; $('languages').append(b); }
  write_harmonics();
}
function begin() { busy = false; solve(true); }
recall();
chips('glasses', DATA.glasses, 'glass');
chips('tables', DATA.tables, 'table');
load_entries();
speak();
make_sliders();
$('answer').textContent = T().start;
$('harmonics').oninput = () => { state.harmonics = Number($('harmonics').value); write_harmonics(); remember(); solve(false); };
$('reset').onclick = () => { state.changes = {}; state.harmonics = all_harmonics; write_harmonics(); make_sliders(); remember(); solve(true); };
$('restart').onclick = () => { omega = omega_paper = psi = psi_paper = 0; phi = Math.PI / 2; };
$('pause').setAttribute('aria-pressed', held);
$('pause').onclick = () => { held = !held; $('pause').setAttribute('aria-pressed', held); };
$('as-prm').onclick = () => download('explored.prm', 'text/plain', study_text());
$('as-csv').onclick = () => download('explored.csv', 'text/csv', csv_of(all_curves()));
$('as-link').onclick = async () => { try { await navigator.clipboard.writeText(location.href); $('as-link').textContent = T().copied; setTimeout(() => { $('as-link').textContent = T().as_link; }, 1500); } catch { prompt('', location.href); } };
$('as-print').onclick = () => print();
$('measured').onchange = e => take_file(e.target.files[0]);
addEventListener('dragover', e => e.preventDefault());
addEventListener('drop', e => { e.preventDefault(); take_file(e.dataTransfer.files[0]); });
addEventListener('hashchange', () => { state.changes = {}; recall(); choose(); });
requestAnimationFrame(frame);
// What a test asks: moves an entry, and waits for the answer of the last wish.
window.move = (path, value) => new Promise(done => {
  if (value === undefined) delete state.changes[path]; else state.changes[path] = String(value);
  make_sliders(); remember(); solve(true);
  const wait = () => busy || wish ? setTimeout(wait, 10) : done({ omega: answer.all ? answer.all.omega : null, error: answer.error || '', errors, text: $('answer').textContent });
  wait();
});
start_solver().catch(error => lost(String(error)));
