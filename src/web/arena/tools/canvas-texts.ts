import type { Texts } from '#core/texts';

/** What the arena says while a tool is used by keyboard; it comes with the tools. */
export const canvasTexts = {
  place: { de: '{x} | {y} cm', fr: '{x} | {y} cm', it: '{x} | {y} cm', en: '{x} | {y} cm' },
  drawing: {
    de: 'Ansetzen bei {x} | {y} cm',
    fr: 'Commence à {x} | {y} cm',
    it: 'Comincia a {x} | {y} cm',
    en: 'Starting at {x} | {y} cm',
  },
  copied: {
    de: 'Kopiert, Ctrl+V fügt ein',
    fr: 'Copié, Ctrl+V colle',
    it: 'Copiato, Ctrl+V incolla',
    en: 'Copied, Ctrl+V pastes',
  },
  dropped: { de: 'Verworfen', fr: 'Abandonné', it: 'Scartato', en: 'Dropped' },
  help: {
    de: 'Pfeiltasten bewegen das Fadenkreuz, Eingabe setzt an und ab, Esc verwirft.',
    fr: 'Les flèches déplacent le viseur, Entrée commence et termine, Échap abandonne.',
    it: 'I tasti freccia spostano il mirino, Invio comincia e finisce, Esc scarta.',
    en: 'Arrow keys move the crosshair, Enter starts and ends, Escape drops.',
  },
  helpSelected: {
    de: 'Pfeiltasten verschieben die Auswahl, Q und E drehen, Entfernen löscht, Esc hebt die Auswahl auf.',
    fr: 'Les flèches déplacent la sélection, Q et E la tournent, Suppr l’efface, Échap la quitte.',
    it: 'I tasti freccia spostano la selezione, Q ed E la ruotano, Canc la elimina, Esc la lascia.',
    en: 'Arrow keys move the selection, Q and E turn it, Delete removes it, Escape deselects.',
  },
} as const satisfies Readonly<Record<string, Texts>>;
