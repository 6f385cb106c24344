import type { Texts } from '#core/texts';

/** The words of sharing, saving and opening in the top bar: they come with the page. */
export const barTexts = {
  share: { de: 'Teilen', en: 'Share' },
  save: { de: 'Projekt speichern', en: 'Save project' },
  open: { de: 'Datei öffnen', en: 'Open a file' },
} as const satisfies Readonly<Record<string, Texts>>;
