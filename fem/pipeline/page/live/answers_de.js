// Sentences of the solver in German, by the keys of sentence() in C++; {0}, {1} are its values.
export const answers_de = {
  tips_at_rest:
    'Die Momentenbilanz {0} verlangt ein Momentenverhältnis von {1}, aber bei {2} kippt das Glas; Höhe der Hand oder Geschwindigkeit ändern.',
  tips: 'Kein Druck am Rand hält diesem Moment das Gleichgewicht.',
  no_contact: 'Die Kontaktrechnung konvergiert nicht; einen der Werte ändern.',
  contact_width: 'Das Netz dieser Seite löst die Breite dieses Kontakts nicht auf; stemware run verwenden.',
  other_mesh: '{0} braucht ein anderes Netz als das dieser Seite; stemware run verwenden.',
  not_allowed: '{1} = {2} ist nicht zulässig.',
  other_failure: 'Der Löser meldet: {0}',
  no_spin: 'Die Drehmomente haben im untersuchten Bereich keine Nullstelle.',
  implausible: '{0} liegt für ein Glas außerhalb von {1} bis {2}; Zahl und Einheit prüfen.',
  implausible_unit: '{0} liegt für ein Glas außerhalb von {1} bis {2}; {3} schreiben, falls das gemeint ist.'
};
