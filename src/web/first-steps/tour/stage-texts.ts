/** What the stages are called, in the greeting and in the menu, and what else the menu has for beginners. */
export const stageTexts = {
  stages: { de: 'Was du siehst', fr: 'Ce que tu vois', it: 'Che cosa vedi', en: 'What you see' },
  board: {
    name: { de: 'Mikrocomputer', fr: 'Carte', it: 'Scheda', en: 'Microcomputer' },
    about: {
      de: 'Lichter, Tasten, Töne',
      fr: 'Lumières, boutons, sons',
      it: 'Luci, pulsanti, suoni',
      en: 'Lights, buttons, sounds',
    },
  },
  robot: {
    name: { de: 'Roboter', fr: 'Robot', it: 'Robot', en: 'Robot' },
    about: { de: 'Fahren und messen', fr: 'Rouler et mesurer', it: 'Muoversi e misurare', en: 'Driving and measuring' },
  },
  all: {
    name: { de: 'Parcours bauen', fr: 'Construire un parcours', it: 'Costruire percorsi', en: 'Build courses' },
    about: {
      de: 'Eigene Linien und Wände',
      fr: 'Tes lignes et tes murs',
      it: 'Linee e muri tuoi',
      en: 'Your own lines and walls',
    },
  },
  startTour: { de: 'Rundgang', fr: 'Visite guidée', it: 'Visita guidata', en: 'Tour' },
  resumeTour: {
    de: 'Rundgang fortsetzen',
    fr: 'Continuer la visite guidée',
    it: 'Continua la visita guidata',
    en: 'Go on with the tour',
  },
  help: { de: 'Hilfe', fr: 'Aide', it: 'Aiuto', en: 'Help' },
} as const;
