import type { Texts } from '#core/texts';

import type { CourseKind, CourseLevel } from '../project/course';
import type { RandomKind, RandomSize } from './random-wish';

/** The words of the gallery of courses; they come with it. */
export const courseGalleryTexts = {
  title: { de: 'Alle Kurse', en: 'All courses' },
  intro: {
    de: 'Jeder Kurs hat eine Aufgabe und ein Programm zum Weiterschreiben. Deine Arbeit bleibt aufbewahrt.',
    en: 'Each course has a task and a program to go on with. Your work is kept.',
  },
  close: { de: 'Galerie schliessen', en: 'Close the gallery' },
  filter: { de: 'Was für Kurse', en: 'What kind of courses' },
  every: { de: 'Alle', en: 'All' },
  random: { de: 'Zufällig', en: 'Random' },
  shown: { de: '{count} Kurse', en: '{count} courses' },
  open: { de: 'Öffnen', en: 'Open' },
  openLong: { de: 'Öffnen: {name}', en: 'Open: {name}' },
  again: { de: 'Noch einmal öffnen', en: 'Open again' },
  againLong: { de: 'Noch einmal öffnen: {name}', en: 'Open again: {name}' },
  isOpen: { de: 'Jetzt offen', en: 'Open now' },
  more: { de: 'Mehr', en: 'More' },
  moreLong: { de: 'Mehr über {name}', en: 'More about {name}' },
  task: { de: 'Aufgabe', en: 'Task' },
  level: { de: 'Schwierigkeit', en: 'Difficulty' },
  robot: { de: 'Roboter', en: 'Robot' },
  arena: { de: 'Arena', en: 'Arena' },
  sizeCm: { de: '{width} × {height} cm', en: '{width} × {height} cm' },
  time: { de: 'Zeit', en: 'Time' },
  seconds: { de: 'höchstens {seconds} s', en: '{seconds} s at most' },
  rule: { de: 'Regel', en: 'Rule' },
  noTouch: { de: 'nirgends anstossen', en: 'touch nothing' },
  solution: { de: 'Lösung zeigen', en: 'Show the solution' },
  solutionHint: {
    de: 'Versuche es zuerst selbst: Es gibt mehr als einen Weg.',
    en: 'Try it yourself first: there is more than one way.',
  },
  openSolved: { de: 'Mit der Lösung öffnen', en: 'Open with the solution' },
  copy: { de: 'Adresse kopieren', en: 'Copy the address' },
  copied: { de: 'Kopiert', en: 'Copied' },
  copyFailed: {
    de: 'Der Browser lässt das Kopieren nicht zu. Das ist die Adresse:',
    en: 'The browser does not allow copying. This is the address:',
  },
  unknown: { de: 'Diesen Kurs gibt es hier nicht.', en: 'There is no such course here.' },
  seed: { de: 'Zahl', en: 'Number' },
  seedHint: {
    de: 'Dieselbe Zahl gibt überall denselben Kurs: Schreib sie auf, und alle fahren das Gleiche.',
    en: 'The same number gives the same course everywhere: write it down, and everyone drives the same.',
  },
  seedProblem: { de: 'Nur ganze Zahlen von 1 bis 999999', en: 'Only whole numbers from 1 to 999999' },
  newSeed: { de: 'Neue Zahl', en: 'New number' },
  size: { de: 'Grösse', en: 'Size' },
} as const satisfies Readonly<Record<string, Texts>>;

export const kindTexts: Readonly<Record<CourseKind, Texts>> = {
  free: { de: 'Frei', en: 'Free' },
  line: { de: 'Linie', en: 'Line' },
  drive: { de: 'Fahren', en: 'Driving' },
  obstacles: { de: 'Hindernisse', en: 'Obstacles' },
  maze: { de: 'Labyrinth', en: 'Maze' },
  blocks: { de: 'Klötze', en: 'Blocks' },
};

export const levelTexts: Readonly<Record<CourseLevel, Texts>> = {
  1: { de: 'leicht', en: 'easy' },
  2: { de: 'mittel', en: 'medium' },
  3: { de: 'schwer', en: 'hard' },
};

export const sizeTexts: Readonly<Record<RandomSize, Texts>> = {
  s: { de: 'klein', en: 'small' },
  m: { de: 'mittel', en: 'medium' },
  l: { de: 'gross', en: 'large' },
};

/** What random courses are called, and what they say about themselves. */
export const randomTexts: Readonly<
  Record<RandomKind, { readonly title: Texts; readonly name: Texts; readonly text: Texts; readonly task: Texts }>
> = {
  maze: {
    title: { de: 'Zufälliges Labyrinth', en: 'Random maze' },
    name: { de: 'Labyrinth {seed}, {size}', en: 'Maze {seed}, {size}' },
    text: {
      de: 'Aus der Zahl {seed}: dieselbe Zahl gibt überall dasselbe Labyrinth.',
      en: 'Made from the number {seed}: the same number gives the same maze everywhere.',
    },
    task: {
      de: 'Finde den Weg zum Ziel. Es gibt genau einen, und eine schwarze Linie zeigt dir, dass du da bist.',
      en: 'Find the way to the target. There is exactly one, and a black line tells you that you are there.',
    },
  },
  track: {
    title: { de: 'Zufällige Linie', en: 'Random line' },
    name: { de: 'Linie {seed}, {size}', en: 'Line {seed}, {size}' },
    text: {
      de: 'Aus der Zahl {seed}: dieselbe Zahl gibt überall dieselbe Linie.',
      en: 'Made from the number {seed}: the same number gives the same line everywhere.',
    },
    task: {
      de: 'Folge der Linie eine Runde lang: durch die Kontrollpunkte 1 bis 3 und zurück zum Start.',
      en: 'Follow the line for one lap: past checkpoints 1 to 3 and back to the start.',
    },
  },
};
