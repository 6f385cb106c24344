import type { Texts } from '#core/texts';

import type { Paper } from './print-plan';

/** The words of the window for pictures and printing; they come with it. */
export const printTexts = {
  title: { de: 'Bild und Druck', en: 'Picture and print' },
  close: { de: 'Schliessen', en: 'Close' },
  what: { de: 'Was du brauchst', en: 'What you need' },
  picture: { de: 'Bild für ein Arbeitsblatt', en: 'Picture for a worksheet' },
  print: { de: 'Im Massstab 1:1 drucken', en: 'Print true to scale' },
  preview: { de: 'Vorschau', en: 'Preview' },
  shows: { de: 'Auf dem Bild', en: 'On the picture' },
  grid: { de: 'Raster', en: 'Grid' },
  rulers: { de: 'Lineale in cm', en: 'Rulers in cm' },
  robot: { de: 'Roboter am Start', en: 'Robot at its start' },
  path: { de: 'Spur des Roboters', en: 'Path of the robot' },
  png: { de: 'PNG', en: 'PNG' },
  pngLong: { de: 'PNG: Bild speichern', en: 'PNG: save the picture' },
  pngLarge: { de: 'PNG, gross', en: 'PNG, large' },
  pngLargeLong: { de: 'PNG, gross: Bild für den Druck speichern', en: 'PNG, large: save a picture for printing' },
  svg: { de: 'SVG', en: 'SVG' },
  svgLong: {
    de: 'SVG: als Zeichnung speichern (für Inkscape und Word)',
    en: 'SVG: save as a drawing (for Inkscape and Word)',
  },
  paper: { de: 'Papier', en: 'Paper' },
  sheets: { de: '{count} Blätter', en: '{count} sheets' },
  oneSheet: { de: '1 Blatt', en: '1 sheet' },
  tooMany: {
    de: '{count} Blätter: das sind zu viele. Nimm grösseres Papier oder verkleinere die Arena.',
    en: '{count} sheets are too many. Take larger paper, or make the arena smaller.',
  },
  manySheets: {
    de: 'Das sind viele Blätter zum Kleben. Mit grösserem Papier geht es schneller.',
    en: 'These are many sheets to glue. With larger paper it is done faster.',
  },
  tooLarge: { de: 'Dafür ist die Arena zu gross.', en: 'The arena is too large for this.' },
  tooLargeShort: { de: 'zu gross', en: 'too large' },
  outlines: {
    de: 'Dünne Umrisse, wo Wände, Blöcke und der Start sind',
    en: 'Thin outlines where walls, blocks and the start are',
  },
  about: {
    de: 'Gedruckt wird der Boden: Linien, Felder, Texte und das Hintergrundbild, alles in wirklicher Grösse.',
    en: 'What is printed is the floor: lines, zones, texts and the background picture, all in real size.',
  },
  pdf: { de: 'PDF speichern', en: 'Save as PDF' },
  working: { de: 'Einen Moment …', en: 'Just a moment …' },
  failed: {
    de: 'Das hat nicht geklappt. Vielleicht fehlt die Verbindung oder der Speicher reicht nicht.',
    en: 'That did not work. Perhaps there is no connection, or too little memory.',
  },
  saved: { de: '{file} ist gespeichert.', en: '{file} has been saved.' },
  planTitle: {
    de: 'Bauplan: {columns} × {rows} Blätter, zusammen {width} × {height} cm',
    en: 'Plan: {columns} × {rows} sheets, together {width} × {height} cm',
  },
} as const satisfies Readonly<Record<string, Texts>>;

/** How to print and glue; on the first sheet of a print. */
export const stepTexts: readonly Texts[] = [
  {
    de: '1. Drucke mit «Tatsächliche Grösse» (100 %), nicht «Anpassen». Miss nach: dieses Lineal muss 100 mm lang sein.',
    en: '1. Print with “Actual size” (100 %), not “Fit”. Check it: this ruler must be 100 mm long.',
  },
  {
    de: '2. Schneide bei jedem Blatt den Rand rechts und unten an den Eckmarken ab.',
    en: '2. On each sheet, cut off the margin on the right and below at the corner marks.',
  },
  {
    de: '3. Lege das Blatt auf das nächste, mit der geschnittenen Kante an dessen gestrichelte Marken, und klebe es fest.',
    en: '3. Lay the sheet on the next one, with the edge you cut at its dashed marks, and glue it down.',
  },
  {
    de: '4. Klebe zuerst jede Reihe (A1, B1, …), dann die Reihen untereinander.',
    en: '4. Glue each row first (A1, B1, …), then the rows below each other.',
  },
];

/** The papers by name. */
export const paperTexts: Readonly<Record<Paper, Texts>> = {
  'a4-tiles': { de: 'A4 zum Zusammenkleben', en: 'A4, to glue together' },
  'a3-tiles': { de: 'A3 zum Zusammenkleben', en: 'A3, to glue together' },
  a3: { de: 'Ein Blatt A3', en: 'One sheet of A3' },
  a2: { de: 'Ein Blatt A2', en: 'One sheet of A2' },
  a1: { de: 'Ein Blatt A1', en: 'One sheet of A1' },
  a0: { de: 'Ein Blatt A0', en: 'One sheet of A0' },
  exact: { de: 'Ein Blatt nach Mass', en: 'One sheet made to measure' },
};
