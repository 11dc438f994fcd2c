// Values at the pointer or the selected point, and zoom by dragging.
import { rich_svg, s, width_of } from './dom.js';
import { missing, shown } from './words.js';

function place_of(figure, event) {
  const frame = figure.svg.getBoundingClientRect();
  const factor = figure.width / frame.width;
  return [(event.clientX - frame.left) * factor, (event.clientY - frame.top) * factor];
}

/** Returns the label of a point: its `words`, or its numbers and the values of other curves at the same x. */
function lines_at(figure, mark, i) {
  const { x = {}, y = {}, equal } = figure.picture;
  const at = mark.at(i);
  if (at.words) return [].concat(at.words);
  const say = (axis, v) => {
    const text = shown(v, axis.digits || '.5g');
    return text + (axis.unit && axis.unit !== '1' && text !== missing ? ' ' + axis.unit : '');
  };
  const others = figure.shown_marks.filter(m => m.value && m.name);
  const own = `${mark.name ? mark.name + ': ' : ''}${say(y, at.y)}${at.band > 0 ? ' ± ' + shown(at.band, 'band') : ''}`;
  const beside = mark.value && !equal && others.length ? others.map(m => `${m.name}: ${say(y, m.value(at.x))}`) : [own];
  return [`${x.symbol || (x.label || '') + ':'} ${say(x, at.x)}`, ...beside];
}

function show_point(figure, mark, i, found) {
  const lines = lines_at(figure, mark, i);
  const at = mark.at(i);
  const spot = found || { px: figure.X(at.x), py: figure.Y(at.y) };
  const wide = Math.max(...lines.map(width_of)) + 16;
  const tall = 18 * lines.length + 10;
  const left = Math.max(0, Math.min(spot.px + 12, figure.width - wide));
  const top = Math.max(0, Math.min(spot.py - tall - 8, figure.height - tall));
  const upright = { d: `M${spot.px} ${figure.box.top}V${figure.box.bottom}`, stroke: 'var(--soft)' };
  figure.tip.replaceChildren(
    ...(mark.value && !figure.picture.equal ? [s('path', { ...upright, 'stroke-dasharray': '2 3' })] : []),
    s('circle', { cx: spot.px, cy: spot.py, r: 4.5, fill: 'none', stroke: 'var(--ink)', 'stroke-width': 1.5 }),
    s('rect', { x: left, y: top, width: wide, height: tall, rx: 5, fill: 'var(--card)', stroke: 'var(--line)' }),
    ...lines.map((words, k) => s('text', { x: left + 8, y: top + 19 + 18 * k }, rich_svg(words)))
  );
  return lines;
}

export function hover(figure, event) {
  if (figure.dragging) return;
  const [px, py] = event ? place_of(figure, event) : [-99, -99];
  const { box, tip } = figure;
  let best = null;
  if (px > box.left - 8 && px < box.right + 8 && py > box.top - 8 && py < box.bottom + 8)
    for (const mark of figure.shown_marks) {
      const found = mark.near(px, py, figure.X, figure.Y);
      if (found && (!best || found.away < best.found.away)) best = { mark, found };
    }
  if (best && best.found.away < 60) show_point(figure, best.mark, best.found.i, best.found);
  else tip.replaceChildren();
}

/** Moves from point to point with the arrow keys, also for screen readers; Escape resets the zoom. */
export function key(figure, event) {
  if (event.key === 'Escape') {
    figure.chosen = null;
    figure.zoom(null);
  }
  const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
  const marks = figure.shown_marks.filter(m => m.count);
  if (!step || !marks.length) return;
  event.preventDefault();
  let [mark, i] = figure.chosen && marks.includes(figure.chosen[0]) ? figure.chosen : [marks[0], -1];
  i += step;
  if (i >= mark.count || i < 0) {
    mark = marks[(marks.indexOf(mark) + step + marks.length) % marks.length];
    i = step > 0 ? 0 : mark.count - 1;
  }
  figure.chosen = [mark, i];
  figure.said.textContent = show_point(figure, mark, i).join(', ');
}

export function follow(svg, event, move, end = () => {}) {
  const ended = new AbortController();
  const listen = (name, act) => svg.addEventListener(name, act, { signal: ended.signal });
  svg.setPointerCapture(event.pointerId);
  listen('pointermove', move);
  for (const name of ['pointerup', 'pointercancel']) listen(name, e => (ended.abort(), end(e)));
}

export function drag(figure, event) {
  const { box, svg, picture } = figure;
  if (picture.equal || picture.y?.rows || event.button || event.target.closest('.name')) return;
  const from = place_of(figure, event);
  if (from[0] < box.left || from[0] > box.right || from[1] < box.top || from[1] > box.bottom) return;
  const touch = event.pointerType === 'touch'; // a finger also scrolls the page, so it zooms horizontally only
  const frame = s('rect', { fill: 'var(--c1)', 'fill-opacity': 0.12, stroke: 'var(--c1)' });
  const begin = touch ? [from[0], box.top] : from;
  const inside = e => {
    const [x, y] = place_of(figure, e);
    const kept = (v, low, high) => Math.max(low, Math.min(high, v));
    return [kept(x, box.left, box.right), touch ? box.bottom : kept(y, box.top, box.bottom)];
  };
  const move = e => {
    const to = inside(e);
    ['x', 'y'].forEach((name, k) => frame.setAttribute(name, Math.min(begin[k], to[k])));
    ['width', 'height'].forEach((name, k) => frame.setAttribute(name, Math.abs(begin[k] - to[k])));
  };
  const end = e => {
    figure.dragging = false;
    frame.remove();
    const to = inside(e);
    const sorted = (scale, k) => [scale.invert(begin[k]), scale.invert(to[k])].sort((p, q) => p - q);
    const is_tall = Math.abs(to[1] - begin[1]) > 12;
    if (e.type === 'pointerup' && Math.abs(to[0] - begin[0]) > 12)
      figure.zoom({ x: sorted(figure.X, 0), y: is_tall && !touch ? sorted(figure.Y, 1) : undefined });
  };
  figure.dragging = true;
  svg.append(frame);
  follow(svg, event, move, end);
}
