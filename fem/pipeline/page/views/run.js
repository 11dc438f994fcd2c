// Page of `stemware run`.
import { around } from '../js/series.js';
import { bands, beginning, ending, fewer_harmonics, files, study } from './common.js';
import { columns, table_of } from '../js/tables.js';
import { driven, phases, spin_up, torque, torque_of_harmonics } from './spin.js';
import { effects, waterfall } from './budget.js';
import { foot_from_above, footprint, rim, section, section_stress } from './foot.js';
import { higher_harmonics, line_load, load_polar, slip, spectrum, table_of_harmonics } from './load.js';
import { shown } from '../js/words.js';

const without_keys = 'name omega_terminal difference relative_difference remark';
const chain_keys = 'step title omega_terminal difference relative_difference band remark';

function budget_sections(doc) {
  const { words } = doc;
  const formal =
    'Each step adds one effect to the model before it; its difference is the effect’s size. A load is called formal if it ' +
    'is negative somewhere (tensile, not physical).';
  return [
    {
      title: 'From the paper’s model to this study’s',
      text: [[words.lift_off, words.pressed, words.thin_layer, words.out_of_flat].filter(Boolean).join(' '), formal],
      pictures: ending(doc).spins && [waterfall(doc), effects(doc)],
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

function load_sections(doc) {
  const { load } = doc.summary;
  const rounding = Math.max(1e-6 * Math.hypot(...load.moment), 1e-12 * load.normal_force * load.ring_radius);
  const [moment_x, moment_y] = load.moment.map(part => (Math.abs(part) > rounding ? part : 0));
  const n_rings = load.radii.length;
  const ring = n_rings > 1 ? `The pressure acts on ${n_rings} rings; one ring` : 'The ring';
  return [
    {
      title: 'The load on the table',
      text:
        `At rest the glass presses on the table with N = ${shown(load.normal_force)} N and the moment ` +
        `M_N = (${shown(moment_x)}, ${shown(moment_y)}) N m, a moment ratio m = |M_N| / (N R / 2) of ` +
        `${shown(load.moment_ratio, '.4g')}. Above 1 a first-harmonic load is negative somewhere; at 2 the glass tips. ` +
        `${shown(load.contact_fraction, '.1f%')} of the land is under pressure; the least load is ${shown(load.least_load, '.4g')} N/rad.`,
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
        {
          name: 'load_harmonics',
          given: table_of_harmonics(doc),
          title: `Harmonics of the load over its mean, a_0 = ${shown(load.a[0])} N/rad`
        }
      ]
    }
  ];
}

function spin_text(doc) {
  const { summary } = doc;
  const { ring } = summary;
  const { falls, spins } = ending(doc);
  const at_rest = summary.ring.tau_at_rest;
  const text =
    `Friction turns the glass at rest with τ_z = ${shown(at_rest, '#.4g')} N m; μ M_Nx, which depends on the first harmonic ` +
    `only, is ${shown(at_rest && ring.tau_closed_form, '#.4g')} N m.`;
  if (falls)
    return `${text} The spin-up ends at ${shown(ring.fall.omega, '.3g')} rad/s, where the glass tips over.`;
  if (!spins) return text;
  const others = [ring.lean_torque_at_terminal && 'the lean torque', ring.grip_torque_at_terminal && 'the torque of the fingers'];
  const named = ['', ...others.filter(Boolean)];
  const sum = named.length > 1 ? `${named.join(named.length > 2 ? ', ' : ' and ')} add up to zero` : ' vanishes';
  return (
    `${text} Friction’s torque${sum}${summary.waviness ? ', on average over time,' : ''} at the terminal spin ` +
    `ω = ${shown(ring.omega_terminal, '#.4g')} rad/s, which is ${shown(Math.abs(ring.omega_terminal) / (2 * Math.PI), '.3g')} turns per second` +
    (ring.time_constant > 0
      ? `; the glass approaches it with a time constant of ${shown(ring.time_constant, '.4g')} s.`
      : '.')
  );
}

const table_of_spins = spins =>
  table_of(
    ['spin ω (rad/s)', 'stability', 'time constant (s)', ''],
    spins.map(({ omega, held, stable, time_constant, from_rest }) => [
      omega,
      held ? 'held by the fingers' : stable ? 'stable' : 'unstable',
      time_constant,
      from_rest ? 'reached from rest' : ''
    ])
  );

function spin_sections(doc) {
  const { words, tables, summary } = doc;
  return [
    {
      title: 'Torque and spin',
      text: spin_text(doc),
      pictures: [ending(doc).moves && spin_up(doc), torque(doc), torque_of_harmonics(doc)]
    },
    tables.phases && { title: 'Torque over the phase', folded: true, pictures: [phases(doc)] },
    words.several_spins && {
      title: 'All terminal spins',
      text:
        `${words.several_spins} Searched within 1.5 v/R of rest. The spin approaches a stable terminal spin with its time constant ` +
        'and leaves an unstable one with it.',
      tables: [{ name: 'terminal_spins', given: table_of_spins(summary.ring.terminal_spins) }]
    },
    words.driven && { title: 'Spin-up under measured speeds of the hand', text: words.driven, pictures: driven(doc) }
  ];
}

function foot_sections(doc) {
  const { tables, words } = doc;
  const { foot } = tables;
  if (!foot) return [];
  const maps = [
    footprint(foot.footprint, 'footprint', 'at rest'),
    footprint(
      foot.footprint_at_end,
      'footprint_at_end',
      ending(doc).falls ? 'where the glass tips over' : 'at the terminal spin'
    )
  ];
  return [
    { title: 'The foot', pictures: [section_stress(tables), foot_from_above(tables, words), maps] },
    foot.section && { title: 'The section and the rim', folded: true, pictures: [section(tables), rim(tables)] }
  ];
}

function glasses(doc) {
  const { ring, load, load_at_terminal, load_at_fall, budget } = doc.summary;
  const { paper } = columns(doc.tables.spin_up);
  const [before, last] = [paper[Math.floor(0.9 * paper.length)], paper[paper.length - 1]];
  const is_over = paper.length > 10 && Math.abs(last - before) <= 1e-2 * Math.abs(last); // the paper's spin-up has ended
  const omega = budget?.[0].omega_terminal ?? (is_over ? last : null);
  const this_load = around(load_at_terminal || load_at_fall || load, 72);
  return [
    { title: 'this glass', omega: ring.omega_terminal, load: this_load },
    ...(omega === null ? [] : [{ title: 'the paper\'s rigid ring', omega }])
  ];
}

export function run(doc) {
  const { words, tables, summary } = doc;
  return {
    ...beginning(doc, glasses(doc)),
    sections: [
      tables.chain && budget_sections(doc),
      load_sections(doc),
      spin_sections(doc),
      foot_sections(doc),
      summary.load.a.length > 2 && ending(doc).spins && { ...fewer_harmonics(doc), folded: true },
      {
        title: 'Friction at rest and at the end',
        folded: true,
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
