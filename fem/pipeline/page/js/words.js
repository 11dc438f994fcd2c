// Formats of numbers and texts. Digits are written as in summary.schema.json: ".6g", "+.3g%", "band".
export const missing = '–';

const raised = n => String(n).replace(/[-\d]/g, c => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(c)]);
const pretty = text => text.replace(/e([+-]?\d+)$/, (_, n) => ' · 10' + raised(Number(n))).replace(/^1 · 10/, '10');
const true_minus = text => text.replace(/(^|[\s([<>=±≤,])-(?=\d)/g, '$1−');

/** Formats like printf's %g; `whole` keeps trailing zeros. */
function general(x, n, whole) {
  const power = x === 0 ? 0 : Math.floor(Math.log10(Math.abs(Number(x.toPrecision(n)))));
  const text = power < -4 || power >= Math.max(n, 6) ? x.toExponential(n - 1) : x.toFixed(Math.max(0, n - 1 - power));
  return whole ? text : text.replace(/(\.\d*?)0+(?=e|$)/, '$1').replace(/\.(?=e|$)/, '');
}

/** Rounds the half-width of an error band up to two digits, so that the shown band is not narrower. */
function rounded_up(x) {
  const unit = 10 ** (Math.floor(Math.log10(x)) - 1);
  return Math.ceil((x / unit) * (1 - 1e-9)) * unit;
}

export function shown(value, digits = '.6g') {
  if (value === null || value === undefined || (typeof value === 'number' && !Number.isFinite(value))) return missing;
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  if (typeof value === 'string') return cell(value);
  if (Number.isInteger(value) && digits === '.6g' && Math.abs(value) < 1e6) return true_minus(String(value));
  if (digits === 'band') return value > 0 ? shown(rounded_up(value), '.1e') : '0';
  const [, sign, whole, n, kind, percent] = /^(\+?)(#?)\.?(\d*)([gef])(%?)$/.exec(digits);
  const x = value * (percent ? 100 : 1);
  const places = Number(n || 6);
  if (x === 0 && !whole) return percent ? '0 %' : '0';
  const text = kind === 'g' ? general(x, places, whole) : kind === 'e' ? x.toExponential(places) : x.toFixed(places);
  return (sign && x > 0 ? '+' : '') + true_minus(pretty(text)) + (percent ? ' %' : '');
}

function cell(text) {
  const number = /^[-+]?\d/.test(text) && /^\S+$/.test(text);
  return number ? true_minus(/^0\.?0*e/.test(text) ? '0' : pretty(text)) : true_minus(text);
}
export const is_number = text => /^[-−+]?\d/.test(text) || text === missing || text === '';

export const say = (text, ...values) => with_units(text.replace(/\{(\d)\}/g, (_, i) => values[i]));

export const heading_of = q => q.heading + (q.unit && q.unit !== '1' ? ` (${q.unit.replace(/ /g, '\u00a0')})` : '');
export const label_of = ({ label = '', unit }) => heading_of({ heading: label, unit });

/** Joins numbers and units by non-breaking spaces, with superscript exponents. */
const with_units = text =>
  text
    .replace(/(?<=\d ?)um(?=[\s.,;)/]|$)/g, 'µm')
    .replace(/ (?=%|rad\/s)|(?<=μ) (?=\d)|(?<=[\d…}]) (?=(?:°|[kMGcmµn]?(?:m|s|g|N|Pa))(?:[\s/.,;:)\]]|$))/g, '\u00a0')
    .replace(/(?<=\u00a0[mµn]?N) m(?=[\s.,;:)]|$)/g, '\u00a0m')
    .replace(/(?<=[mgs])\^([23])(?!\d)/g, (_, n) => raised(n));

/** Splits a text into words and subscripts { sub } of one-letter symbols (τ_z, a_10, z_CM). */
export function pieces(text) {
  const whole = with_units(true_minus(String(text)));
  const parts = whole.split(/(?<=(?:^|[^A-Za-z0-9_])[A-Za-z\u0370-\u03ff])_([A-Za-z0-9]+)/);
  return parts.map((part, i) => (i % 2 ? { sub: part } : part));
}

const field = x => (/[",\r\n]/.test(String(x)) ? `"${String(x).replace(/"/g, '""')}"` : String(x ?? ''));
export const csv = rows => rows.map(row => row.map(field).join(',') + '\r\n').join('');
