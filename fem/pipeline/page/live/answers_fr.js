// Sentences of the solver in French, by the keys of sentence() in C++; {0}, {1} are its values.
export const answers_fr = {
  tips_at_rest:
    'L’équilibre des moments {0} demande un rapport de moment de {1}, mais à {2} le verre bascule ; changer la hauteur de la main ou la vitesse.',
  tips: 'Aucune pression au bord n’équilibre ce moment.',
  no_contact: 'Le calcul du contact ne converge pas ; changer une des valeurs.',
  contact_width: 'Le maillage de cette page ne résout pas la largeur de ce contact ; utiliser stemware run.',
  other_mesh: '{0} demande un autre maillage que celui de cette page ; utiliser stemware run.',
  not_allowed: '{1} = {2} n’est pas admis.',
  other_failure: 'Le solveur signale : {0}',
  no_spin: 'Les couples n’ont pas de zéro dans l’intervalle exploré.',
  implausible: '{0} est en dehors de {1} à {2} pour un verre ; vérifier le nombre et l’unité.',
  implausible_unit: '{0} est en dehors de {1} à {2} pour un verre ; écrire {3} si c’est voulu.'
};
