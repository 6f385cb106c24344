import type { Texts } from '#core/texts';

/** What the arena says while a tool is used by keyboard; it comes with the tools. */
export const canvasTexts = {
  place: { de: '{x} | {y} cm', en: '{x} | {y} cm' },
  drawing: { de: 'Ansetzen bei {x} | {y} cm', en: 'Starting at {x} | {y} cm' },
  dropped: { de: 'Verworfen', en: 'Dropped' },
  help: {
    de: 'Pfeiltasten bewegen das Fadenkreuz, Eingabe setzt an und ab, Esc verwirft.',
    en: 'Arrow keys move the crosshair, Enter starts and ends, Escape drops.',
  },
  helpSelected: {
    de: 'Pfeiltasten verschieben die Auswahl, Q und E drehen, Entfernen löscht, Esc hebt die Auswahl auf.',
    en: 'Arrow keys move the selection, Q and E turn it, Delete removes it, Escape deselects.',
  },
} as const satisfies Readonly<Record<string, Texts>>;
