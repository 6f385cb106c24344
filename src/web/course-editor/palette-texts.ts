import type { Texts } from '#core/texts';

import type { ArenaTool } from '../composables/use-course-editor';

/** The words of the tools; they come with the palette. */
export const paletteTexts = {
  tools: { de: 'Werkzeuge', en: 'Tools' },
  unfold: { de: 'Werkzeuge zeigen', en: 'Show the tools' },
  fold: { de: 'Werkzeuge wegklappen', en: 'Fold the tools away' },
  undo: { de: 'Rückgängig (Ctrl+Z)', en: 'Undo (Ctrl+Z)' },
  redo: { de: 'Wiederholen (Ctrl+Y)', en: 'Redo (Ctrl+Y)' },
  more: { de: 'Mehr zur Strecke', en: 'More about the course' },
} as const satisfies Readonly<Record<string, Texts>>;

/** What a tool is called under its picture, and what it does. */
export const toolTexts: Readonly<Record<ArenaTool, { readonly name: Texts; readonly about: Texts }>> = {
  hand: {
    name: { de: 'Hand', en: 'Hand' },
    about: {
      de: 'Hand: Roboter und Blöcke im Lauf verschieben',
      en: 'Hand: move the robot and blocks during the run',
    },
  },
  select: {
    name: { de: 'Auswählen', en: 'Select' },
    about: { de: 'Auswählen und verschieben', en: 'Select and move' },
  },
  rotate: {
    name: { de: 'Drehen', en: 'Turn' },
    about: { de: 'Antippen dreht um 45 Grad', en: 'A tap turns by 45 degrees' },
  },
  pen: {
    name: { de: 'Stift', en: 'Pen' },
    about: { de: 'Stift: Linien auf den Boden malen', en: 'Pen: paint lines on the floor' },
  },
  eraser: {
    name: { de: 'Radierer', en: 'Eraser' },
    about: { de: 'Radierer: Linien oder Dinge wegnehmen', en: 'Eraser: take lines or things away' },
  },
  block: {
    name: { de: 'Block', en: 'Block' },
    about: {
      de: 'Block: beweglich, fest, mit Stacheln oder fahrend',
      en: 'Block: loose, fixed, with spikes or moving',
    },
  },
  wall: { name: { de: 'Wand', en: 'Wall' }, about: { de: 'Wand ziehen', en: 'Draw a wall' } },
  maze: {
    name: { de: 'Labyrinth', en: 'Maze' },
    about: { de: 'Labyrinth: Kanten antippen', en: 'Maze: tap the edges of the grid' },
  },
  zone: {
    name: { de: 'Feld', en: 'Zone' },
    about: { de: 'Feld: Ziel, Kontrollpunkt oder verboten', en: 'Zone: target, checkpoint or forbidden' },
  },
  label: { name: { de: 'Text', en: 'Text' }, about: { de: 'Text auf den Boden schreiben', en: 'Write on the floor' } },
  start: {
    name: { de: 'Start', en: 'Start' },
    about: { de: 'Start des Roboters: Ort, Richtung, Grösse', en: 'Start of the robot: place, heading, size' },
  },
  ruler: {
    name: { de: 'Messen', en: 'Measure' },
    about: { de: 'Abstand und Winkel messen', en: 'Measure distance and angle' },
  },
};
