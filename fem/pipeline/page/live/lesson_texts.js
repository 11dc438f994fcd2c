// Texts of the lesson; {0}, {1} are numbers. A list has one answer per correct option of the step.
export const lesson_texts = {
  step: 'Step {0} of 5: {1}',
  right: 'As you said.',
  half: 'Half right.',
  other: 'Not quite.',
  back: 'Back',
  next: 'Next step',
  tips: 'This glass tips over: the hand would need more counter-moment than the weight can give. Move the hand to another height, or go slower.',
  steps: [
    {
      title: 'press',
      question:
        'The hand pulls the glass towards the centre of its circle, at the height of the green ring. What does this pull do to the foot?',
      options: ['It presses the outside harder.', 'It presses the inside harder.', 'It presses both sides alike.'],
      answer: [
        'The hand pulls {0} mm below the centre of mass. The glass would rather go straight on, so it leans outwards, and the outside is pressed harder. The moment of {1} mN m tries to tip the glass.',
        'The hand pulls {0} mm above the centre of mass. It pulls the top inwards while the rest would rather go straight on, so the glass leans inwards, and the inside is pressed harder. The moment of {1} mN m tries to tip the glass.',
        'The hand pulls at the centre of mass. Nothing leans the glass outwards or inwards, and both sides are pressed alike.'
      ],
      then: 'Look at the wall round the rim: its height is the pressure. Drag the hand up and down.'
    },
    {
      title: 'pressure',
      question: 'How does the pressure change along the rim, once round?',
      options: [
        'It jumps from a low to a high half.',
        'It rises and falls once, evenly.',
        'It is high at one place only.'
      ],
      answer: [
        '',
        'It rises and falls once: a first harmonic. At rest it is {0} N/m on the inside and {1} N/m on the outside. The moment ratio is {2}; beyond 1 a part of the rim lifts off, at 2 the glass tips.',
        'A part of the rim has lifted off, and the rest carries the glass. At rest the pressure is {0} N/m on the inside and {1} N/m on the outside. The moment ratio is {2}; beyond 1 a part of the rim lifts off, at 2 the glass tips.'
      ],
      also: 'also ',
      then: 'The pressure is {0}high in front: the hand pulls forwards above the table, friction holds the rim back, and the glass leans forwards. The solid curve is the load by angle, the dashed one its first harmonic only. The second harmonic is {1} % of the mean on this table.'
    },
    {
      title: 'friction',
      question:
        'The glass does not spin yet, so every point of the rim slides the same way. Which friction can turn the glass?',
      options: ['The net force.', 'The difference between the two sides.', 'None: all arrows are parallel.'],
      answer: [
        '',
        'Equal arrows left and right would cancel. The longer ones win: the net force of {0} N acts beside the axis.',
        'Only a difference between the sides turns a glass. Here the arrows left and right are equal and cancel: the net force of {0} N acts through the axis.'
      ],
      then: 'Blue arrows turn the glass clockwise, orange ones counter-clockwise. Count them by their length.'
    },
    {
      title: 'torque',
      question: 'Seen from above: which way does the friction drive the glass?',
      options: ['Against its orbit.', 'With its orbit.', 'Not at all.'],
      answer: [
        'Friction drives it against its orbit. The torque at rest is {0} mN m: the coefficient of friction times the moment of the hand.',
        'Friction drives it with its orbit. The torque at rest is {0} mN m: the coefficient of friction times the moment of the hand.',
        'Friction does not drive it: both sides have the same friction, and the torque at rest is zero.'
      ],
      then: 'The arrow round the stem is the torque that is left. Play the spin-up: at its end the arrow is gone, or the glass tips.',
      none: 'No torque is left, and no arrow is drawn round the stem.'
    },
    {
      title: 'terminal spin',
      question: 'Why does the spin of a glass stop growing?',
      options: [
        'The hand gets tired.',
        'The spinning rim slides in new directions; friction tilts until its torques cancel.',
        'The air brakes the glass.'
      ],
      answer:
        'The spinning rim slides in new directions; friction tilts until its torques cancel. That is at {0} rad/s, one turn in {1} s.',
      paper: 'The rigid ring of the paper has {0} rad/s.',
      still: 'Friction that tilts would brake a spin. Here nothing starts one: the torque at rest is zero.',
      held: 'Friction that tilts would brake a spin. Here the fingers hold the glass: their torque is larger than that of friction.',
      falls:
        'Friction that tilts would brake the spin. This glass tips over before, at {0} rad/s. Move the hand to another height, or go slower.',
      then: 'Now a last prediction: what happens if the hand crosses the centre of mass? Drag it. At the centre of mass nothing turns; below, the glass spins against its orbit; above, it spins with its orbit, and soon it tips.',
      too_high: 'Now a last prediction: what happens if the hand moves up? Drag it. This glass tips with the hand at about {0} mm, before the hand is at the centre of mass.',
      gripped: 'Set “Grip” under “More” to less than the torque at rest: the glass begins to spin.'
    }
  ]
};
