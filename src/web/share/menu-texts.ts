import type { Texts } from '#core/texts';

/** The words of saving and opening in the main menu; they come with it. */
export const menuTexts = {
  saveProgram: {
    de: 'Nur das Programm speichern',
    fr: 'Enregistrer le programme',
    it: 'Salva solo il programma',
    en: 'Save the program only',
  },
  saveScene: {
    de: 'Nur die Strecke speichern',
    fr: 'Enregistrer le parcours',
    it: 'Salva solo il percorso',
    en: 'Save the course only',
  },
  openFile: { de: 'Datei öffnen …', fr: 'Ouvrir un fichier…', it: 'Apri un file …', en: 'Open a file …' },
  openLink: { de: 'Link öffnen …', fr: 'Ouvrir un lien…', it: 'Apri un link …', en: 'Open a link …' },
} as const satisfies Readonly<Record<string, Texts>>;
