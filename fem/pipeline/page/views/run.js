// What `stemware run` shows.
import { bands, beginning, fewer_harmonics, files, study } from './common.js';
import { driven, phases, spin_up, torque } from './spin.js';
import { effects, harmonic_torque, waterfall } from './budget.js';
import { foot_from_above, footprint, rim, section, section_stress } from './foot.js';
import { higher_harmonics, line_load, load_polar, slip, spectrum } from './load.js';
import { shown } from '../js/words.js';

const without_keys = 'name omega_terminal difference relative_difference remark';
const chain_keys = 'step title omega_terminal difference relative_difference band remark';

function budget_sections(doc) {
  const { words, summary } = doc;
  const formal =
    'Each step adds one effect to the model before it; its difference is the effect’s size. A load is called formal if it ' +
    'is negative somewhere (tensile, not physical).';
  const spins = Number.isFinite(summary.ring.omega_terminal) && words.numbers.spins;
  return [
    {
      title: 'From the paper’s model to this study’s',
      text: [[words.lift_off, words.pressed, words.thin_layer, words.out_of_flat].filter(Boolean).join(' '), formal],
      pictures: spins && [waterfall(doc), effects(doc)],
      tables: [{ name: 'without', keys: without_keys, title: 'The complete model without one effect at a time' }]
    },
    {
      title: 'The steps in numbers',
      folded: true,
      text: 'In the rows n ≤ 1, 2, 3 ... the contact has its whole pressure; friction and torque use the harmonics kept.',
      tables: [
        { name: 'chain', keys: chain_keys, title: 'Terminal spin in models of increasing detail' },
        { name: 'chain_torques', title: 'Torque τ_z at rest, at half and at full terminal spin of this study' }
      ]
    }
  ];
}

/** Parts of a vector, those that are rounding as 0. */
const without_rounding = parts => parts.map(part => (Math.abs(part) > 1e-6 * Math.hypot(...parts) ? part : 0));

function load_sections(doc) {
  const { load } = doc.summary;
  const { numbers, load: words } = doc.words;
  const [moment_x, moment_y] = without_rounding([numbers.moment_x, numbers.moment_y]);
  const ring = numbers.rings > 1 ? `The pressure acts on ${numbers.rings} rings; one ring` : 'The ring';
  return [
    {
      title: 'The load on the table',
      text:
        `At rest the glass presses on the table with N = ${shown(load.normal_force)} N and the moment ` +
        `M_N = (${shown(moment_x)}, ${shown(moment_y)}) N m, a moment ratio m = |M_N| / (N R / 2) of ` +
        `${shown(load.moment_ratio, '.4g')}. Above 1 a first-harmonic load is negative somewhere; at 2 the glass tips. ` +
        `${shown(load.contact_fraction, '.1f%')} of the land is under pressure; the minimum load is ${shown(load.minimum, '.4g')} N/rad.`,
      pictures: [
        load_polar(doc),
        slip(doc, 'slip_at_rest', 'at rest'),
        slip(doc, 'slip_at_end', 'at the terminal spin')
      ]
    },
    {
      title: 'The load in numbers',
      folded: true,
      text: `${ring} with the same N, M_N and first harmonic has a radius of ${shown(load.ring_radius)} m.`,
      pictures: [spectrum(doc), line_load(doc), higher_harmonics(doc)],
      tables: [
        { name: 'load_harmonics', title: `Harmonics of the load over its mean, a_0 = ${shown(words.mean)} N/rad` }
      ]
    }
  ];
}

function spin_text({ summary, words }) {
  const { numbers } = words;
  const { ring } = summary;
  const text =
    `Friction turns the glass at rest with τ_z = ${shown(numbers.torque_at_rest)} N m; μ M_Nx, which depends on the first harmonic ` +
    `only, is ${shown(numbers.closed_form)} N m.`;
  if (numbers.falls)
    return `${text} The spin-up ends at ${shown(ring.fall.omega, '.3g')} rad/s, where the glass tips over.`;
  if (!numbers.spins) return text;
  const sum = numbers.others ? `${numbers.others} add up to zero` : ' vanishes';
  return (
    `${text} Friction’s torque${sum}${summary.waviness ? ', on average over time,' : ''} at the terminal spin ` +
    `ω = ${shown(ring.omega_terminal)} rad/s, which is ${shown(Math.abs(ring.omega_terminal) / (2 * Math.PI), '.3g')} turns per second` +
    (ring.time_constant > 0
      ? `; the glass approaches it with a time constant of ${shown(ring.time_constant, '.4g')} s.`
      : '.')
  );
}

function spin_sections(doc) {
  const { words, tables, summary } = doc;
  const compared = tables.harmonic_torque?.values[0].length > 0 && !words.numbers.falls && summary.load.a.length > 2;
  return {
    compared,
    sections: [
      {
        title: 'Torque and spin',
        text: spin_text(doc),
        pictures: [words.numbers.moves && spin_up(doc), compared ? harmonic_torque(doc) : torque(doc)]
      },
      tables.phases && { title: 'Torque over the phase', folded: true, pictures: [phases(doc)] },
      words.several_spins && {
        title: 'All terminal spins',
        text:
          `${words.several_spins} Searched within 1.5 v/R of rest. The spin approaches a stable terminal spin with its time constant ` +
          'and leaves an unstable one with it.',
        tables: [{ name: 'terminal_spins' }]
      },
      words.driven && { title: 'Spin-up under measured speeds of the hand', text: words.driven, pictures: driven(doc) }
    ]
  };
}

function foot_sections({ tables, words }) {
  const { foot } = tables;
  if (!foot) return [];
  const maps = [
    footprint(foot.footprint, 'footprint', 'at rest'),
    footprint(
      foot.footprint_at_end,
      'footprint_at_end',
      words.numbers.falls ? 'where the glass tips over' : 'at the terminal spin'
    )
  ];
  return [
    { title: 'The foot', pictures: [section_stress(tables), foot_from_above(tables, words), maps] },
    foot.section && { title: 'The section and the rim', folded: true, pictures: [section(tables), rim(tables)] }
  ];
}

/** The answer with the load cut off after some harmonics. */

export function run(doc) {
  const { words, tables, summary } = doc;
  const spin = spin_sections(doc);
  return {
    ...beginning(doc),
    sections: [
      tables.chain && budget_sections(doc),
      load_sections(doc),
      spin.sections,
      foot_sections(doc),
      words.load.harmonics > 1 && words.numbers.spins && { ...fewer_harmonics(doc), folded: true },
      {
        title: 'Friction at rest and at the end',
        folded: true,
        pictures: [spin.compared && torque(doc)],
        tables: [{ name: 'friction', title: 'Torques on the glass and friction force of the table' }]
      },
      summary.contact && {
        title: 'The contact at rest',
        folded: true,
        text: words.narrow_contact,
        tables: [{ name: 'contact' }]
      },
      bands(doc),
      study(doc),
      files(doc)
    ]
  };
}
