// The lesson in German; {0}, {1} are numbers.
export const lesson_de = {
  step: 'Schritt {0} von 5: {1}',
  right: 'Wie vorhergesagt.',
  other: 'Es ist anders.',
  back: 'Zurück',
  next: 'Nächster Schritt',
  steps: [
    {
      title: 'drücken',
      question:
        'Die Hand zieht das Glas zur Mitte seines Kreises, in der Höhe des grünen Rings. Was bewirkt dieser Zug am Fuß?',
      options: [
        'Er drückt die Außenseite stärker.',
        'Er drückt die Innenseite stärker.',
        'Er drückt beide Seiten gleich.'
      ],
      answer:
        'Der Zug greift {0} mm neben dem Schwerpunkt an. Sein Moment von {1} mN m kippt das Glas; der Tisch muss mit seinem Druck dagegenhalten.',
      then: 'Die Höhe der Wand am Rand ist der Druck. Ziehen Sie die Hand auf und ab.'
    },
    {
      title: 'Druck',
      question: 'Wie ändert sich der Druck den Rand entlang, einmal herum?',
      options: [
        'Er springt von einer Hälfte zur anderen.',
        'Er steigt und fällt einmal, gleichmäßig.',
        'Er ist nur an einer Stelle hoch.'
      ],
      answer:
        'Er steigt und fällt einmal: eine erste Harmonische. In Ruhe sind es {0} N/m innen und {1} N/m außen. Das Momentenverhältnis ist {2}; über 1 hebt der Rand teilweise ab, bei 2 kippt das Glas.',
      then: 'Die durchgezogene Kurve ist die Last über dem Winkel, die gestrichelte nur ihre erste Harmonische. Wählen Sie Eiche: eine zweite, kleinere Welle kommt hinzu.'
    },
    {
      title: 'Reibung',
      question: 'In Ruhe gleiten alle Stellen des Randes in eine Richtung. Welche Reibung kann das Glas drehen?',
      options: [
        'Die gesamte Kraft.',
        'Der Unterschied zwischen den beiden Seiten.',
        'Keine: alle Pfeile sind parallel.'
      ],
      answer:
        'Die gesamte Kraft von {0} N wirkt nur so weit neben der Achse, wie die Pfeile einer Seite länger sind. Der Unterschied dreht das Glas; gleiche Pfeile drehten es nicht.',
      then: 'Blaue Pfeile drehen das Glas im Uhrzeigersinn, orange dagegen. Ihre Länge zählt.'
    },
    {
      title: 'Drehmoment',
      question: 'Von oben gesehen: wohin dreht die Reibung das Glas?',
      options: ['Gegen die Umlaufrichtung.', 'Mit der Umlaufrichtung.', 'Gar nicht.'],
      answer: 'Das Drehmoment in Ruhe ist {0} mN m: der Reibwert mal das Moment der Hand.',
      then: 'Der Pfeil um den Stiel ist das übrige Drehmoment. Spielen Sie den Anlauf ab: der Pfeil schrumpft.'
    },
    {
      title: 'Enddrehung',
      question: 'Warum wächst die Drehung nicht weiter?',
      options: [
        'Die Hand wird müde.',
        'Die Drehung dreht die Reibung, bis beide Seiten gleich stark sind.',
        'Die Luft bremst das Glas.'
      ],
      answer:
        'Ein drehendes Glas gleitet in andere Richtungen; die Pfeile drehen sich, bis sich ihre Drehmomente aufheben: bei {0} rad/s, einer Umdrehung in {1} s. Der starre Ring des Artikels hat {2} rad/s.',
      then: 'Eine letzte Vorhersage: was geschieht, wenn die Hand den Schwerpunkt überschreitet? Ziehen Sie sie hinauf. Am Schwerpunkt dreht sich nichts; darüber dreht sich das Glas mit der Umlaufrichtung, und bald kippt es.'
    }
  ]
};
