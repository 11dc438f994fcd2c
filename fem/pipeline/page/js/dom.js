// Elements of HTML and SVG. Texts become text nodes, so that no document content is parsed as HTML.
import { pieces } from './words.js';

function element(space, tag, attributes, children) {
  const node = space ? document.createElementNS('http://www.w3.org/2000/svg', tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {}))
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (value !== undefined && value !== null && value !== false)
      node.setAttribute(name, value === true ? '' : value);
  node.append(...children.flat(9).filter(child => child !== null && child !== undefined && child !== false));
  return node;
}
export const h = (tag, attributes, ...children) => element(false, tag, attributes, children);
export const s = (tag, attributes, ...children) => element(true, tag, attributes, children);

/** Returns the nodes of a plain text with subscripts. */
export const rich = text => pieces(text).map(piece => (typeof piece === 'object' ? h('sub', {}, piece.sub) : piece));
/** Returns the nodes of a plain text with subscripts for SVG. */
export const rich_svg = text =>
  pieces(text).flatMap((piece, i) =>
    typeof piece === 'object' // typeof, because a string has a method `sub`
      ? [s('tspan', { dy: 3, 'font-size': '80%' }, piece.sub), s('tspan', { dy: -3 }, '\u200b')]
      : piece || i === 0
        ? [piece]
        : []
  );

export function download(name, content, type) {
  const link = h('a', { download: name, href: URL.createObjectURL(new Blob([content], { type })) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

export const font = '13px system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif';
const ruler = document.createElement('canvas').getContext('2d');
export function width_of(text) {
  ruler.font = font;
  return ruler.measureText(text).width;
}
