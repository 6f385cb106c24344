import type { Texts } from '#core/texts';

/** The words of saving and opening in the main menu; they come with it. */
export const menuTexts = {
  saveProgram: { de: 'Nur das Programm speichern', en: 'Save the program only' },
  saveScene: { de: 'Nur die Strecke speichern', en: 'Save the course only' },
  openFile: { de: 'Datei öffnen …', en: 'Open a file …' },
  openLink: { de: 'Link öffnen …', en: 'Open a link …' },
} as const satisfies Readonly<Record<string, Texts>>;
