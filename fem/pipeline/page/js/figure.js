// Interactive picture: axes, legend, values at the pointer or the selected point, zoom by dragging,
// and files. A picture is data: { id, title, caption, words, x, y, marks, height, equal, aspect, colours, edge }.
import { same_step, scale, widest } from './axes.js';
import { colour_bar, names_of } from './legend.js';
import { buttons, svg_text } from './files.js';
import { hover, key, drag } from './pointer.js';
import { h, rich, rich_svg, s, width_of } from './dom.js';
import { label_of } from './words.js';

const clip_ids = { last: 0 };

function lines_of(text, room) {
  if (width_of(text) <= room) return [text];
  const words = text.split(' ');
  const longer = k => Math.max(words.slice(0, k).join(' ').length, words.slice(k).join(' ').length);
  const breaks = words.map((_, k) => k).slice(1);
  const at = breaks.reduce((best, k) => (longer(k) < longer(best) ? k : best), breaks[0]);
  return at ? [words.slice(0, at).join(' '), words.slice(at).join(' ')] : [text];
}

export class Figure {
  constructor(picture) {
    this.hidden = new Set();
    this.zoomed = null;
    this.chosen = null; // [mark, index] selected by the arrow keys
    this.svg = s('svg', { role: 'group', 'aria-roledescription': 'picture', tabindex: 0 });
    this.said = h('p', { class: 'said', 'aria-live': 'polite' });
    this.caption = h('figcaption');
    this.controls = h('div', { class: 'controls' });
    this.node = h('figure', { class: 'plot' }, this.controls, this.svg, this.caption, this.said);
    for (const [event, act] of Object.entries({
      pointermove: e => hover(this, e),
      pointerleave: () => hover(this, null),
      pointerdown: e => drag(this, e),
      dblclick: () => this.zoom(null),
      keydown: e => key(this, e)
    }))
      this.svg.addEventListener(event, act);
    this.set(picture);
  }

  set(picture) {
    this.picture = picture;
    this.node.id = picture.id;
    this.svg.setAttribute('aria-label', `${picture.title}. ${picture.words || ''}`);
    this.caption.replaceChildren(
      h('b', {}, rich(picture.title + '. ')),
      ...rich(picture.caption || ''),
      ' ',
      buttons(this)
    );
    this.redraw();
  }

  redraw(width = this.width || 480) {
    this.width = width;
    this.svg.replaceChildren(...this.draw(width));
    this.svg.setAttribute('viewBox', `0 0 ${width} ${this.height}`);
  }

  zoom(ranges) {
    this.zoomed = ranges;
    this.redraw();
    this.controls.replaceChildren(...(ranges ? [h('button', { onclick: () => this.zoom(null) }, 'all of it')] : []));
  }

  toggle(name) {
    this.hidden.has(name) ? this.hidden.delete(name) : this.hidden.add(name);
    this.redraw();
    [...this.svg.querySelectorAll('.name')].find(node => node.dataset.name === name)?.focus();
  }

  height_of(width, names_height) {
    const { equal, aspect, y = {}, height } = this.picture;
    if (equal) return Math.round(width * (aspect || 0.8)) + names_height;
    if (y.rows) return names_height + 62 + 30 * y.rows.length;
    return height || Math.round(Math.min(360, 150 + 0.35 * width));
  }

  /** Returns all elements for a width. Stores scales and box, which pointer.js uses. */
  draw(width) {
    const { x = {}, y = {}, marks, equal, colours, edge } = this.picture;
    this.shown_marks = marks.filter(m => !m.name || !this.hidden.has(m.name));
    const extents = this.shown_marks.map(m => m.extent());
    const found = { x: extents.flatMap(e => e.x), y: extents.flatMap(e => e.y) };
    const names = names_of(this, width);
    const right = colours ? 78 : edge ? 16 + Math.max(...edge.map(width_of)) : 14;
    const height = (this.height = this.height_of(width, names.height));
    const box = {
      top: names.height + (y.label && !y.rows && !equal ? 26 : colours ? 26 : 8),
      bottom: height - (equal ? 6 : 46),
      left: 12,
      right: width - right
    };
    const zoomed = this.zoomed || {};
    const ends = y.rows ? [box.top, box.bottom] : [box.bottom, box.top];
    let Y = scale({ ...y, range: zoomed.y || y.range }, found.y, ...ends);
    if (!equal) box.left = Math.min((y.rows && width < 440 ? 0.44 : 0.6) * width, Math.max(30, widest(Y) + 12));
    const close = { close: x.log ? 48 : 78 };
    let X = scale({ ...x, ...close, range: zoomed.x || x.range }, found.x, box.left, box.right);
    if (equal) [X, Y] = same_step(X, Y, box);
    Object.assign(this, { X, Y, box });
    const clip = `clip-${this.picture.id}-${++clip_ids.last}`;
    const area = equal
      ? { x: 0, y: names.height, width, height: height - names.height }
      : { x: box.left - 6, y: box.top - 6, width: Math.max(0, box.right - box.left + 12), height: box.bottom - box.top + 12 };
    return [
      s('clipPath', { id: clip }, s('rect', area)),
      equal ? [] : this.axes(width),
      s('g', { 'clip-path': `url(#${clip})` }, ...this.shown_marks.map(m => m.draw(X, Y, box))),
      colours ? colour_bar(colours, box, width) : [],
      names.nodes,
      (this.tip = s('g', { class: 'tip', 'pointer-events': 'none' }))
    ]
      .flat(9)
      .filter(Boolean);
  }

  axes(width) {
    const { X, Y, box } = this;
    const { x = {}, y = {}, edge } = this.picture;
    const text = (content, attributes) => s('text', { class: 'soft', ...attributes }, rich_svg(content));
    const grid = d => s('path', { d, stroke: 'var(--grid)', fill: 'none' });
    const line = d => s('path', { d, stroke: 'var(--line)', fill: 'none' });
    let end = -Infinity; // end of the previous tick label
    const room_for = (at, words) => {
      const half = width_of(words) / 2 + 5;
      const there = at - half > end;
      if (there) end = at + half;
      return there;
    };
    const keep = (at, words) => Math.min(width - width_of(words) / 2 - 1, Math.max(width_of(words) / 2 + 1, at));
    return [
      Y.ticks.list.map(v => [
        y.rows ? [] : grid(`M${box.left} ${Y(v).toFixed(1)}H${box.right}`),
        lines_of(Y.ticks.text(v), box.left - 9).map((words, i, { length }) =>
          text(words, {
            x: box.left - 7,
            y: (Y(v) + 4.5 + 15 * (i - (length - 1) / 2)).toFixed(1),
            'text-anchor': 'end',
            class: y.rows ? '' : 'soft'
          })
        )
      ]),
      X.ticks.list.map(v => [
        y.rows ? grid(`M${X(v).toFixed(1)} ${box.top}V${box.bottom}`) : [],
        room_for(keep(X(v), X.ticks.text(v)), X.ticks.text(v))
          ? text(X.ticks.text(v), {
              x: keep(X(v), X.ticks.text(v)).toFixed(1),
              y: box.bottom + 18,
              'text-anchor': 'middle'
            })
          : []
      ]),
      line(y.rows ? `M${box.left} ${box.bottom}H${box.right}` : `M${box.left} ${box.top}V${box.bottom}H${box.right}`),
      !y.rows && !y.log && Y.range[0] < 0 && Y.range[1] > 0
        ? s('path', { d: `M${box.left} ${Y(0)}H${box.right}`, stroke: 'var(--soft)' })
        : [],
      (edge || []).map((words, i) =>
        s('text', { x: width - 2, y: (Y(i) + 4.5).toFixed(1), 'text-anchor': 'end' }, words)
      ),
      text(label_of(x), { x: box.right, y: this.height - 6, 'text-anchor': 'end' }),
      y.label ? text(label_of(y), { x: 2, y: box.top - 10 }) : []
    ];
  }

  alone(width) {
    const { width: present, picture } = this;
    const nodes = this.draw(width);
    const { height } = this;
    const text = svg_text(picture.title, picture.words || picture.caption || '', nodes, width, height);
    this.redraw(present);
    return { text, width, height };
  }
}
