import type { Texts } from '#core/texts';

/** The words of the list of objects; they come with it. */
export const listTexts = {
  add: { de: 'Hinzufügen', fr: 'Ajouter', it: 'Aggiungi', en: 'Add' },
  robot: { de: 'Start des Roboters', fr: 'Départ du robot', it: 'Partenza del robot', en: 'Start of the robot' },
  remove: { de: 'Löschen', fr: 'Supprimer', it: 'Elimina', en: 'Delete' },
  removeOne: { de: '{what} löschen', fr: 'Supprimer : {what}', it: 'Elimina: {what}', en: 'Delete {what}' },
  none: {
    de: 'Noch liegt nichts in der Arena.',
    fr: 'Il n’y a encore rien dans l’arène.',
    it: 'Nell’arena non c’è ancora niente.',
    en: 'Nothing lies in the arena yet.',
  },
  more: {
    de: 'Noch {count} zeigen',
    fr: 'Afficher encore {count}',
    it: 'Mostra altri {count}',
    en: 'Show {count} more',
  },
} as const satisfies Readonly<Record<string, Texts>>;
