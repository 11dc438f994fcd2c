// Texts of the class sheet, as in docs/lesson_class.md.
export const sheet_texts = {
  title: 'The spinning wine glass: for the class',
  question: 'A glass is led on a circle by its stem. Nobody turns it, yet it begins to spin. Why, which way, and how fast?',
  parts: [
    {
      title: 'Predict, before you try',
      text: 'Write down what you expect, and one sentence why.',
      head: ['question', 'I expect', 'because', 'I saw'],
      rows: [
        '1. The orbit is counter-clockwise, seen from above, and the hand is low on the stem. Which way does the glass spin?',
        '2. The hand is as high as the centre of mass of the glass.',
        '3. The hand is higher than that.',
        '4. Half the speed on the same circle: how much of the spin is left?',
        '5. A table with half the friction.',
        '6. A glass of the same shape with twice the mass.'
      ]
    },
    {
      title: 'Measure',
      text: 'Film from above. Count the turns of a dot on the foot in the room, not along the circle. Change one thing between runs.',
      head: ['quantity', 'run 1', 'run 2', 'run 3'],
      rows: [
        'mass (g)',
        'radius of the foot’s ring (mm)',
        'height of the centre of mass (mm)',
        'height of the hand above the table (mm)',
        'radius ρ of the circle (cm)',
        'time of ten rounds (s), and v = 20 π ρ / time',
        'time of ten turns of the glass (s), and ω = 20 π / time',
        'ω of this page with these values'
      ]
    },
    {
      title: 'Explain',
      text: 'Use the lesson of the page after you have thought.',
      list: [
        'The hand pulls towards the centre of the circle. Which side of the foot is pressed harder when the hand is low, and why?',
        'Friction acts on each piece of the rim against its motion. Sketch the arrows for a glass that does not spin yet. What is their sum, and what is their torque about the axis?',
        'Let the glass spin a little. How do the arrows turn, and why does that brake?',
        'Which measured quantity changes the result most if it is wrong by a little? What do fingers do that do not let the stem turn freely?'
      ]
    }
  ]
};
