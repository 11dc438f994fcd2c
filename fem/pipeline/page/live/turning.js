// The scene of the live page: dragging the hand up and down, and the button for the sense of the orbit.
import { $, at_end, doc, found, hand, hand_offset, is_held, remember, sense, state, value_of } from './state.js';
import { Scene, lengths_of } from '../js/scene.js';
import { h } from '../js/dom.js';
import { shows } from './lesson.js';
import { orbits } from '../js/motion.js';
import { pressing } from '../js/series.js';
import { texts } from './texts.js';
import { why } from '../views/common.js';

let scene = null;
let above = null;

/** Row of a glass that tips and has no answer. */

const fallen = { time: 0, omega: 0, yaw: 0, orbit: 0, torque: 0, hand: [0, 0], load: [], friction: [[], []], turns: [] };

/** Makes the scene. `solve` solves after a move of the hand; `stand` restores the last study without tipping. */
export function make_scene(solve, stand) {
  scene = new Scene(height => {
    state.changes[hand] = String(Number(height.toFixed(3)));
    remember();
    solve(false);
  });
  const turned = () => {
    state.changes['Motion/Orbit sense'] = sense() > 0 ? 'clockwise' : 'counterclockwise';
    remember();
    solve(true);
  };
  scene.drawing.shows = shows;
  above = h('div');
  scene.add_tab(above);
  scene.tabs.append(h('button', { id: 'sense', onclick: turned }, texts.other_sense), h('button', { id: 'stand', onclick: stand, hidden: true }, texts.back));
  $('scene').replaceChildren(scene.node);
}

function draw_above(lengths) {
  const { ring, paper } = doc.summary;
  const load = doc.tables.motion[doc.tables.motion.length - 1].load;
  const glasses = [
    { title: texts.elastic, omega: ring.omega_terminal, load },
    { title: texts.ring, omega: paper.omega_terminal }
  ];
  above.replaceChildren(orbits(glasses, lengths).node);
}

export function draw_scene() {
  if (!found.answer || !scene) return;
  const rows = doc.tables.motion;
  const tips = !rows && found.answer.tips;
  if (!tips && !(rows && found.has_curves) && (scene.given || !rows)) {
    $('stand').hidden = !found.answer.error;
    return scene.given && scene.wait(value_of(hand));
  }
  const falls = tips || Boolean(doc.summary.ring.fall);
  $('stand').hidden = !falls;
  const lengths = lengths_of(value_of, sense());
  scene.set({
    ...lengths,
    rows: rows || [fallen],
    normal_force: doc.summary.load_at_terminal?.normal_force,
    falls,
    most: Math.abs(doc.summary.ring?.tau_at_rest || 0),
    why: why({ falls, held: is_held() }, pressing(at_end()), found.is_last ? hand_offset() : undefined)
  });
  if (rows) draw_above(lengths);
}
