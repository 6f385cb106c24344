import type { Texts } from '#core/texts';

/** The words of the menu of courses; they come with it. */
export const courseListTexts = {
  present: { de: 'Jetzt offen', fr: 'Ouvert maintenant', it: 'Aperto ora', en: 'Open now' },
  again: {
    de: 'Noch einmal von vorn',
    fr: 'Recommencer depuis le début',
    it: 'Di nuovo dall’inizio',
    en: 'Again from the beginning',
  },
  all: {
    de: 'Alle {count} Kurse …',
    fr: 'Tous les {count} parcours…',
    it: 'Tutti i {count} percorsi …',
    en: 'All {count} courses …',
  },
  maze: {
    de: 'Neues zufälliges Labyrinth …',
    fr: 'Nouveau labyrinthe au hasard…',
    it: 'Nuovo labirinto a caso …',
    en: 'New random maze …',
  },
  track: {
    de: 'Neue zufällige Linie …',
    fr: 'Nouvelle ligne au hasard…',
    it: 'Nuova linea a caso …',
    en: 'New random line …',
  },
} as const satisfies Readonly<Record<string, Texts>>;
