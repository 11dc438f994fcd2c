// Legend of a picture, which switches marks off and on, and its colour scale.
import { rich_svg, s, width_of } from './dom.js';
import { colour_at } from './shapes.js';
import { scale } from './axes.js';

function swatch_of(mark, x, y) {
  const colour = `var(--${mark.colour})`;
  if (mark.swatch === 'line')
    return s('path', { d: `M${x} ${y}h18`, stroke: colour, 'stroke-width': 2.5, 'stroke-dasharray': mark.dash });
  if (mark.swatch === 'bar' || mark.swatch === 'square')
    return s('rect', { x: x + 4, y: y - 5, width: 10, height: 10, fill: colour });
  const fill = mark.swatch === 'ring' ? 'var(--card)' : colour;
  return s('circle', { cx: x + 9, cy: y, r: 4, fill, stroke: colour, 'stroke-width': 1.5 });
}

export function names_of(figure, width) {
  const named = figure.picture.marks.filter(m => m.name && m.swatch);
  const unique = named.filter((m, i) => named.findIndex(other => other.name === m.name) === i);
  if (unique.length < 2 && !figure.picture.always_named) return { nodes: [], height: 0 };
  let [x, row] = [2, 0];
  const nodes = unique.map(mark => {
    const wide = 34 + width_of(mark.name);
    if (x > 2 && x + wide > width) [x, row] = [2, row + 1];
    const y = 11 + 20 * row;
    const off = figure.hidden.has(mark.name);
    const toggle = () => figure.toggle(mark.name);
    const acts = { onclick: toggle, onkeydown: e => [' ', 'Enter'].includes(e.key) && (e.preventDefault(), toggle()) };
    const node = s(
      'g',
      { class: 'name', role: 'button', tabindex: 0, 'aria-pressed': String(!off), opacity: off ? 0.35 : 1, ...acts },
      s('rect', { x, y: y - 10, width: wide - 8, height: 20, fill: 'transparent' }),
      swatch_of(mark, x, y),
      s('text', { x: x + 23, y: y + 4.5 }, rich_svg(mark.name))
    );
    node.dataset.name = mark.name;
    x += wide;
    return node;
  });
  return { nodes, height: 20 * (row + 1) + 4 };
}

export function colour_bar({ range, label, both_signs }, box, width) {
  const V = scale({ range, close: 50 }, [], box.bottom - 4, box.top);
  const [x, n] = [width - 70, 48];
  const step = (range[1] - range[0]) / n;
  return [
    Array.from({ length: n }, (_, i) =>
      s('rect', {
        x,
        width: 12,
        y: V(range[0] + (i + 1) * step).toFixed(1),
        height: ((box.bottom - 4 - box.top) / n + 0.5).toFixed(2),
        fill: colour_at((i + 0.5) / n, both_signs)
      })
    ),
    V.ticks.list.map(v => s('text', { class: 'soft', x: x + 17, y: (V(v) + 4.5).toFixed(1) }, V.ticks.text(v))),
    s('text', { class: 'soft', x: width - 2, y: box.top - 11, 'text-anchor': 'end' }, rich_svg(label))
  ];
}
