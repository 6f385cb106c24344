import type { Texts } from '#core/texts';

import type { Paper } from './print-plan';

/** The words of the window for pictures and printing; they come with it. */
export const printTexts = {
  title: { de: 'Bild und Druck', fr: 'Image et impression', it: 'Immagine e stampa', en: 'Picture and print' },
  close: { de: 'Schliessen', fr: 'Fermer', it: 'Chiudi', en: 'Close' },
  what: { de: 'Was du brauchst', fr: 'Ce qu’il te faut', it: 'Che cosa ti serve', en: 'What you need' },
  picture: {
    de: 'Bild für ein Arbeitsblatt',
    fr: 'Image pour une fiche de travail',
    it: 'Immagine per una scheda di lavoro',
    en: 'Picture for a worksheet',
  },
  print: {
    de: 'Im Massstab 1:1 drucken',
    fr: 'Imprimer à l’échelle 1:1',
    it: 'Stampa in scala 1:1',
    en: 'Print true to scale',
  },
  preview: { de: 'Vorschau', fr: 'Aperçu', it: 'Anteprima', en: 'Preview' },
  shows: { de: 'Auf dem Bild', fr: 'Sur l’image', it: 'Sull’immagine', en: 'On the picture' },
  grid: { de: 'Raster', fr: 'Grille', it: 'Griglia', en: 'Grid' },
  rulers: { de: 'Lineale in cm', fr: 'Règles en cm', it: 'Righelli in cm', en: 'Rulers in cm' },
  robot: { de: 'Roboter am Start', fr: 'Robot au départ', it: 'Robot alla partenza', en: 'Robot at its start' },
  path: { de: 'Spur des Roboters', fr: 'Trace du robot', it: 'Traccia del robot', en: 'Path of the robot' },
  png: { de: 'PNG', fr: 'PNG', it: 'PNG', en: 'PNG' },
  pngLong: {
    de: 'PNG: Bild speichern',
    fr: 'PNG : enregistrer l’image',
    it: 'PNG: salva l’immagine',
    en: 'PNG: save the picture',
  },
  pngLarge: { de: 'PNG, gross', fr: 'PNG, grand', it: 'PNG, grande', en: 'PNG, large' },
  pngLargeLong: {
    de: 'PNG, gross: Bild für den Druck speichern',
    fr: 'PNG, grand : enregistrer une image à imprimer',
    it: 'PNG, grande: salva un’immagine per la stampa',
    en: 'PNG, large: save a picture for printing',
  },
  svg: { de: 'SVG', fr: 'SVG', it: 'SVG', en: 'SVG' },
  svgLong: {
    de: 'SVG: als Zeichnung speichern (für Inkscape und Word)',
    fr: 'SVG : enregistrer comme dessin (pour Inkscape et Word)',
    it: 'SVG: salva come disegno (per Inkscape e Word)',
    en: 'SVG: save as a drawing (for Inkscape and Word)',
  },
  paper: { de: 'Papier', fr: 'Papier', it: 'Carta', en: 'Paper' },
  sheets: { de: '{count} Blätter', fr: '{count} feuilles', it: '{count} fogli', en: '{count} sheets' },
  oneSheet: { de: '1 Blatt', fr: '1 feuille', it: '1 foglio', en: '1 sheet' },
  tooMany: {
    de: '{count} Blätter: das sind zu viele. Nimm grösseres Papier oder verkleinere die Arena.',
    fr: '{count} feuilles, c’est trop. Prends du papier plus grand ou réduis l’arène.',
    it: '{count} fogli sono troppi. Usa carta più grande o rimpicciolisci l’arena.',
    en: '{count} sheets are too many. Take larger paper, or make the arena smaller.',
  },
  manySheets: {
    de: 'Das sind viele Blätter zum Kleben. Mit grösserem Papier geht es schneller.',
    fr: 'Cela fait beaucoup de feuilles à coller. Avec du papier plus grand, c’est plus rapide.',
    it: 'Sono tanti fogli da incollare. Con carta più grande si fa prima.',
    en: 'These are many sheets to glue. With larger paper it is done faster.',
  },
  tooLarge: {
    de: 'Dafür ist die Arena zu gross.',
    fr: 'L’arène est trop grande pour cela.',
    it: 'Per questo l’arena è troppo grande.',
    en: 'The arena is too large for this.',
  },
  tooLargeShort: { de: 'zu gross', fr: 'trop grand', it: 'troppo grande', en: 'too large' },
  outlines: {
    de: 'Dünne Umrisse, wo Wände, Blöcke und der Start sind',
    fr: 'Contours fins là où sont les murs, les blocs et le départ',
    it: 'Contorni sottili dove sono i muri, i blocchi e la partenza',
    en: 'Thin outlines where walls, blocks and the start are',
  },
  about: {
    de: 'Gedruckt wird der Boden: Linien, Felder, Texte und das Hintergrundbild, alles in wirklicher Grösse.',
    fr: 'On imprime le sol : lignes, zones, textes et image de fond, le tout en grandeur réelle.',
    it: 'Si stampa il pavimento: linee, zone, testi e immagine di sfondo, tutto a grandezza reale.',
    en: 'What is printed is the floor: lines, zones, texts and the background picture, all in real size.',
  },
  pdf: { de: 'PDF speichern', fr: 'Enregistrer en PDF', it: 'Salva come PDF', en: 'Save as PDF' },
  working: { de: 'Einen Moment …', fr: 'Un instant…', it: 'Un momento …', en: 'Just a moment …' },
  failed: {
    de: 'Das hat nicht geklappt. Vielleicht fehlt die Verbindung oder der Speicher reicht nicht.',
    fr: 'Cela n’a pas marché. Peut-être qu’il manque la connexion ou de la mémoire.',
    it: 'Non ha funzionato. Forse manca la connessione o la memoria non basta.',
    en: 'That did not work. Perhaps there is no connection, or too little memory.',
  },
  saved: {
    de: '{file} ist gespeichert.',
    fr: '{file} est enregistré.',
    it: '{file} è salvato.',
    en: '{file} has been saved.',
  },
  planTitle: {
    de: 'Bauplan: {columns} × {rows} Blätter, zusammen {width} × {height} cm',
    fr: 'Plan : {columns} × {rows} feuilles, ensemble {width} × {height} cm',
    it: 'Piano: {columns} × {rows} fogli, insieme {width} × {height} cm',
    en: 'Plan: {columns} × {rows} sheets, together {width} × {height} cm',
  },
} as const satisfies Readonly<Record<string, Texts>>;

/** How to print and glue; on the first sheet of a print. */
export const stepTexts: readonly Texts[] = [
  {
    de: '1. Drucke mit «Tatsächliche Grösse» (100 %), nicht «Anpassen». Miss nach: dieses Lineal muss 100 mm lang sein.',
    fr: '1. Imprime en « Taille réelle » (100 %), pas « Ajuster ». Vérifie : cette règle doit mesurer 100 mm.',
    it: '1. Stampa con «Dimensioni effettive» (100 %), non «Adatta». Controlla: questo righello deve essere lungo 100 mm.',
    en: '1. Print with “Actual size” (100 %), not “Fit”. Check it: this ruler must be 100 mm long.',
  },
  {
    de: '2. Schneide bei jedem Blatt den Rand rechts und unten an den Eckmarken ab.',
    fr: '2. Sur chaque feuille, coupe la marge à droite et en bas aux repères des coins.',
    it: '2. Su ogni foglio taglia il margine a destra e in basso ai segni degli angoli.',
    en: '2. On each sheet, cut off the margin on the right and below at the corner marks.',
  },
  {
    de: '3. Lege das Blatt auf das nächste, mit der geschnittenen Kante an dessen gestrichelte Marken, und klebe es fest.',
    fr: '3. Pose la feuille sur la suivante, le bord coupé contre ses repères en traitillé, et colle-la.',
    it: '3. Metti il foglio su quello seguente, con il bordo tagliato sui suoi segni tratteggiati, e incollalo.',
    en: '3. Lay the sheet on the next one, with the edge you cut at its dashed marks, and glue it down.',
  },
  {
    de: '4. Klebe zuerst jede Reihe (A1, B1, …), dann die Reihen untereinander.',
    fr: '4. Colle d’abord chaque rangée (A1, B1, …), puis les rangées l’une sous l’autre.',
    it: '4. Incolla prima ogni fila (A1, B1, …), poi le file una sotto l’altra.',
    en: '4. Glue each row first (A1, B1, …), then the rows below each other.',
  },
];

/** The papers by name. */
export const paperTexts: Readonly<Record<Paper, Texts>> = {
  'a4-tiles': {
    de: 'A4 zum Zusammenkleben',
    fr: 'A4 à coller ensemble',
    it: 'A4 da incollare insieme',
    en: 'A4, to glue together',
  },
  'a3-tiles': {
    de: 'A3 zum Zusammenkleben',
    fr: 'A3 à coller ensemble',
    it: 'A3 da incollare insieme',
    en: 'A3, to glue together',
  },
  a3: { de: 'Ein Blatt A3', fr: 'Une feuille A3', it: 'Un foglio A3', en: 'One sheet of A3' },
  a2: { de: 'Ein Blatt A2', fr: 'Une feuille A2', it: 'Un foglio A2', en: 'One sheet of A2' },
  a1: { de: 'Ein Blatt A1', fr: 'Une feuille A1', it: 'Un foglio A1', en: 'One sheet of A1' },
  a0: { de: 'Ein Blatt A0', fr: 'Une feuille A0', it: 'Un foglio A0', en: 'One sheet of A0' },
  exact: {
    de: 'Ein Blatt nach Mass',
    fr: 'Une feuille sur mesure',
    it: 'Un foglio su misura',
    en: 'One sheet made to measure',
  },
};
