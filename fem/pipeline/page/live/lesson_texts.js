// Texts of the lesson; {0}, {1} are numbers.
export const lesson_texts = {
  step: 'Step {0} of 5: {1}',
  right: 'As you said.',
  other: 'It is otherwise.',
  back: 'Back',
  next: 'Next step',
  steps: [
    {
      title: 'press',
      question:
        'The hand pulls the glass towards the centre of its circle, at the height of the green ring. What does this pull do to the foot?',
      options: ['It presses the outside harder.', 'It presses the inside harder.', 'It presses both sides alike.'],
      answer:
        'The pull acts {0} mm beside the centre of mass. Its moment of {1} mN m tips the glass, and the table has to hold against it: with its pressure.',
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
      answer:
        'It rises and falls once: a first harmonic. At rest it is {0} N/m on the inside and {1} N/m on the outside. The moment ratio is {2}; beyond 1 a part of the rim lifts off, at 2 the glass tips.',
      then: 'The solid curve is the load by angle, the dashed one its first harmonic only. Choose oak: a second, smaller wave is added.'
    },
    {
      title: 'friction',
      question: 'At rest all places of the rim slide in one direction. Which friction can turn the glass?',
      options: ['The net force.', 'The difference between the two sides.', 'None: all arrows are parallel.'],
      answer:
        'The net force of {0} N acts along a line beside the axis only as far as the arrows of one side are longer. The difference turns the glass; equal arrows would not.',
      then: 'Blue arrows turn the glass clockwise, orange ones counter-clockwise. Count them by their length.'
    },
    {
      title: 'torque',
      question: 'Seen from above: which way does the friction turn the glass?',
      options: ['Against its orbit.', 'With its orbit.', 'Not at all.'],
      answer: 'The torque at rest is {0} mN m: the coefficient of friction times the moment of the hand.',
      then: 'The arrow round the stem is the torque that is left. Play the spin-up: the arrow shrinks.'
    },
    {
      title: 'terminal spin',
      question: 'Why does the spin stop growing?',
      options: [
        'The hand gets tired.',
        'The spin turns the friction, until both sides balance.',
        'The air brakes the glass.'
      ],
      answer:
        'A glass that spins slides in other directions, and the arrows turn until their torques cancel: at {0} rad/s, one turn in {1} s. The rigid ring of the paper has {2} rad/s.',
      then: 'Now a last prediction: what happens if the hand crosses the centre of mass? Drag it up. At the centre of mass nothing turns; above, the glass spins with its orbit, and soon it tips.'
    }
  ]
};
