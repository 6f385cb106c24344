import type { Texts } from '#core/texts';

/** The words of the menu of courses; they come with it. */
export const courseListTexts = {
  present: { de: 'Jetzt offen', en: 'Open now' },
  again: { de: 'Noch einmal von vorn', en: 'Again from the beginning' },
  all: { de: 'Alle {count} Kurse …', en: 'All {count} courses …' },
  maze: { de: 'Neues zufälliges Labyrinth …', en: 'New random maze …' },
  track: { de: 'Neue zufällige Linie …', en: 'New random line …' },
} as const satisfies Readonly<Record<string, Texts>>;
