import type { Texts } from '#core/texts';

/** The words of the list of objects; they come with it. */
export const listTexts = {
  add: { de: 'Hinzufügen', en: 'Add' },
  robot: { de: 'Start des Roboters', en: 'Start of the robot' },
  remove: { de: 'Löschen', en: 'Delete' },
  removeOne: { de: '{what} löschen', en: 'Delete {what}' },
  none: { de: 'Noch liegt nichts in der Arena.', en: 'Nothing lies in the arena yet.' },
  more: { de: 'Noch {count} zeigen', en: 'Show {count} more' },
} as const satisfies Readonly<Record<string, Texts>>;
