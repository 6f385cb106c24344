import type { Texts } from '#core/texts';

import type { ArenaTool } from '../state/course-editor-model';

/** The words of the tools; they come with the palette. */
export const paletteTexts = {
  tools: { de: 'Werkzeuge', fr: 'Outils', it: 'Strumenti', en: 'Tools' },
  undo: { de: 'Rückgängig (Ctrl+Z)', fr: 'Annuler (Ctrl+Z)', it: 'Annulla (Ctrl+Z)', en: 'Undo (Ctrl+Z)' },
  redo: { de: 'Wiederholen (Ctrl+Y)', fr: 'Rétablir (Ctrl+Y)', it: 'Ripeti (Ctrl+Y)', en: 'Redo (Ctrl+Y)' },
  more: { de: 'Mehr zur Strecke', fr: 'Plus sur le parcours', it: 'Altro sul percorso', en: 'More about the course' },
} as const satisfies Readonly<Record<string, Texts>>;

/** What a tool is called under its picture, and what it does. */
export const toolTexts: Readonly<Record<ArenaTool, { readonly name: Texts; readonly about: Texts }>> = {
  hand: {
    name: { de: 'Hand', fr: 'Main', it: 'Mano', en: 'Hand' },
    about: {
      de: 'Hand: Roboter und Blöcke im Lauf verschieben',
      fr: 'Main : déplacer le robot et les blocs pendant la simulation',
      it: 'Mano: sposta il robot e i blocchi durante la simulazione',
      en: 'Hand: move the robot and blocks during the run',
    },
  },
  select: {
    name: { de: 'Auswählen', fr: 'Sélection', it: 'Seleziona', en: 'Select' },
    about: {
      de: 'Auswählen und verschieben',
      fr: 'Sélectionner et déplacer',
      it: 'Seleziona e sposta',
      en: 'Select and move',
    },
  },
  rotate: {
    name: { de: 'Drehen', fr: 'Tourner', it: 'Ruota', en: 'Turn' },
    about: {
      de: 'Antippen dreht um 45 Grad',
      fr: 'Un toucher tourne de 45 degrés',
      it: 'Un tocco ruota di 45 gradi',
      en: 'A tap turns by 45 degrees',
    },
  },
  pen: {
    name: { de: 'Stift', fr: 'Stylo', it: 'Penna', en: 'Pen' },
    about: {
      de: 'Stift: Linien auf den Boden malen',
      fr: 'Stylo : dessiner des lignes sur le sol',
      it: 'Penna: disegna linee sul pavimento',
      en: 'Pen: paint lines on the floor',
    },
  },
  eraser: {
    name: { de: 'Radierer', fr: 'Gomme', it: 'Gomma', en: 'Eraser' },
    about: {
      de: 'Radierer: Linien oder Dinge wegnehmen',
      fr: 'Gomme : enlever des lignes ou des objets',
      it: 'Gomma: togli linee o oggetti',
      en: 'Eraser: take lines or things away',
    },
  },
  block: {
    name: { de: 'Block', fr: 'Bloc', it: 'Blocco', en: 'Block' },
    about: {
      de: 'Block: beweglich, fest, mit Stacheln oder fahrend',
      fr: 'Bloc : libre, fixe, avec des pics ou mobile',
      it: 'Blocco: libero, fisso, con punte o mobile',
      en: 'Block: loose, fixed, with spikes or moving',
    },
  },
  wall: {
    name: { de: 'Wand', fr: 'Mur', it: 'Muro', en: 'Wall' },
    about: { de: 'Wand ziehen', fr: 'Tirer un mur', it: 'Traccia un muro', en: 'Draw a wall' },
  },
  maze: {
    name: { de: 'Labyrinth', fr: 'Labyrinthe', it: 'Labirinto', en: 'Maze' },
    about: {
      de: 'Labyrinth: Kanten antippen',
      fr: 'Labyrinthe : toucher des bords',
      it: 'Labirinto: tocca i bordi',
      en: 'Maze: tap the edges of the grid',
    },
  },
  zone: {
    name: { de: 'Feld', fr: 'Zone', it: 'Zona', en: 'Zone' },
    about: {
      de: 'Feld: Ziel, Kontrollpunkt oder verboten',
      fr: 'Zone : arrivée, point de contrôle ou interdite',
      it: 'Zona: arrivo, punto di controllo o vietata',
      en: 'Zone: target, checkpoint or forbidden',
    },
  },
  label: {
    name: { de: 'Text', fr: 'Texte', it: 'Testo', en: 'Text' },
    about: {
      de: 'Text auf den Boden schreiben',
      fr: 'Écrire un texte sur le sol',
      it: 'Scrivi un testo sul pavimento',
      en: 'Write on the floor',
    },
  },
  start: {
    name: { de: 'Start', fr: 'Départ', it: 'Partenza', en: 'Start' },
    about: {
      de: 'Start des Roboters: Ort, Richtung, Grösse',
      fr: 'Départ du robot : lieu, direction, taille',
      it: 'Partenza del robot: luogo, direzione, grandezza',
      en: 'Start of the robot: place, heading, size',
    },
  },
  ruler: {
    name: { de: 'Messen', fr: 'Mesurer', it: 'Misura', en: 'Measure' },
    about: {
      de: 'Abstand und Winkel messen',
      fr: 'Mesurer une distance et un angle',
      it: 'Misura distanza e angolo',
      en: 'Measure distance and angle',
    },
  },
};
