// The lesson in French; {0}, {1} are numbers.
export const lesson_fr = {
  step: 'Étape {0} sur 5 : {1}',
  right: 'Comme prévu.',
  other: 'C’est autrement.',
  back: 'Retour',
  next: 'Étape suivante',
  steps: [
    {
      title: 'presser',
      question:
        'La main tire le verre vers le centre de son cercle, à la hauteur de l’anneau vert. Que fait cette traction au pied ?',
      options: [
        'Elle presse plus le côté extérieur.',
        'Elle presse plus le côté intérieur.',
        'Elle presse les deux côtés de même.'
      ],
      answer:
        'La traction agit à {0} mm du centre de masse. Son moment de {1} mN m incline le verre ; la table doit le retenir par sa pression.',
      then: 'La hauteur du mur autour du bord est la pression. Tirer la main vers le haut et vers le bas.'
    },
    {
      title: 'pression',
      question: 'Comment la pression change-t-elle le long du bord, sur un tour ?',
      options: [
        'Elle saute d’une moitié à l’autre.',
        'Elle monte et descend une fois, régulièrement.',
        'Elle n’est forte qu’en un endroit.'
      ],
      answer:
        'Elle monte et descend une fois : une première harmonique. Au repos, {0} N/m à l’intérieur et {1} N/m à l’extérieur. Le rapport de moment est {2} ; au-delà de 1 le bord se soulève en partie, à 2 le verre bascule.',
      then: 'La courbe continue est la charge selon l’angle, la courbe en tirets sa première harmonique seule. Choisir le chêne : une deuxième onde, plus petite, s’ajoute.'
    },
    {
      title: 'frottement',
      question:
        'Au repos, tous les points du bord glissent dans une direction. Quel frottement peut faire tourner le verre ?',
      options: [
        'La force totale.',
        'La différence entre les deux côtés.',
        'Aucun : toutes les flèches sont parallèles.'
      ],
      answer:
        'La force totale de {0} N n’agit à côté de l’axe qu’autant que les flèches d’un côté sont plus longues. La différence fait tourner le verre ; des flèches égales ne le feraient pas.',
      then: 'Les flèches bleues font tourner le verre dans le sens horaire, les oranges dans l’autre. Leur longueur compte.'
    },
    {
      title: 'couple',
      question: 'Vu d’en haut : dans quel sens le frottement fait-il tourner le verre ?',
      options: ['À l’inverse de son orbite.', 'Dans le sens de son orbite.', 'Pas du tout.'],
      answer: 'Le couple au repos est {0} mN m : le coefficient de frottement fois le moment de la main.',
      then: 'La flèche autour de la tige est le couple restant. Jouer le départ : la flèche rétrécit.'
    },
    {
      title: 'rotation finale',
      question: 'Pourquoi la rotation cesse-t-elle de croître ?',
      options: [
        'La main se fatigue.',
        'La rotation tourne le frottement, jusqu’à l’équilibre des deux côtés.',
        'L’air freine le verre.'
      ],
      answer:
        'Un verre qui tourne glisse dans d’autres directions ; les flèches tournent jusqu’à ce que leurs couples s’annulent : à {0} rad/s, un tour en {1} s. L’anneau rigide de l’article a {2} rad/s.',
      then: 'Une dernière prévision : que se passe-t-il si la main dépasse le centre de masse ? La tirer vers le haut. Au centre de masse rien ne tourne ; au-dessus, le verre tourne dans le sens de son orbite, et bientôt il bascule.'
    }
  ]
};
