import type { Texts } from '#core/texts';

import type { CourseKind, CourseLevel } from '../../work/catalogue/course';
import type { RandomKind, RandomSize } from '../../work/catalogue/random-wish';

/** The words of the gallery of courses; they come with it. */
export const courseGalleryTexts = {
  title: { de: 'Alle Kurse', fr: 'Tous les parcours', it: 'Tutti i percorsi', en: 'All courses' },
  intro: {
    de: 'Jeder Kurs hat eine Aufgabe und ein Programm zum Weiterschreiben. Deine Arbeit bleibt aufbewahrt.',
    fr: 'Chaque parcours a une tâche et un programme à compléter. Ton travail reste conservé.',
    it: 'Ogni percorso ha un compito e un programma da completare. Il tuo lavoro resta conservato.',
    en: 'Each course has a task and a program to go on with. Your work is kept.',
  },
  close: { de: 'Galerie schliessen', fr: 'Fermer la galerie', it: 'Chiudi la galleria', en: 'Close the gallery' },
  filter: { de: 'Was für Kurse', fr: 'Quels parcours', it: 'Quali percorsi', en: 'What kind of courses' },
  every: { de: 'Alle', fr: 'Tous', it: 'Tutti', en: 'All' },
  random: { de: 'Zufällig', fr: 'Au hasard', it: 'A caso', en: 'Random' },
  shown: { de: '{count} Kurse', fr: '{count} parcours', it: '{count} percorsi', en: '{count} courses' },
  open: { de: 'Öffnen', fr: 'Ouvrir', it: 'Apri', en: 'Open' },
  openLong: { de: 'Öffnen: {name}', fr: 'Ouvrir : {name}', it: 'Apri: {name}', en: 'Open: {name}' },
  again: { de: 'Noch einmal öffnen', fr: 'Ouvrir encore une fois', it: 'Apri di nuovo', en: 'Open again' },
  againLong: {
    de: 'Noch einmal öffnen: {name}',
    fr: 'Ouvrir encore une fois : {name}',
    it: 'Apri di nuovo: {name}',
    en: 'Open again: {name}',
  },
  isOpen: { de: 'Jetzt offen', fr: 'Ouvert maintenant', it: 'Aperto ora', en: 'Open now' },
  more: { de: 'Mehr', fr: 'Plus', it: 'Altro', en: 'More' },
  moreLong: { de: 'Mehr über {name}', fr: 'Plus sur {name}', it: 'Altro su {name}', en: 'More about {name}' },
  task: { de: 'Aufgabe', fr: 'Tâche', it: 'Compito', en: 'Task' },
  level: { de: 'Schwierigkeit', fr: 'Difficulté', it: 'Difficoltà', en: 'Difficulty' },
  robot: { de: 'Roboter', fr: 'Robot', it: 'Robot', en: 'Robot' },
  arena: { de: 'Arena', fr: 'Arène', it: 'Arena', en: 'Arena' },
  sizeCm: {
    de: '{width} × {height} cm',
    fr: '{width} × {height} cm',
    it: '{width} × {height} cm',
    en: '{width} × {height} cm',
  },
  time: { de: 'Zeit', fr: 'Temps', it: 'Tempo', en: 'Time' },
  seconds: {
    de: 'höchstens {seconds} s',
    fr: 'au plus {seconds} s',
    it: 'al massimo {seconds} s',
    en: '{seconds} s at most',
  },
  rule: { de: 'Regel', fr: 'Règle', it: 'Regola', en: 'Rule' },
  noTouch: { de: 'nirgends anstossen', fr: 'ne rien toucher', it: 'non toccare niente', en: 'touch nothing' },
  solution: { de: 'Lösung zeigen', fr: 'Afficher la solution', it: 'Mostra la soluzione', en: 'Show the solution' },
  solutionHint: {
    de: 'Versuche es zuerst selbst: Es gibt mehr als einen Weg.',
    fr: 'Essaie d’abord par toi-même : il y a plus d’un chemin.',
    it: 'Prova prima da te: c’è più di una via.',
    en: 'Try it yourself first: there is more than one way.',
  },
  openSolved: {
    de: 'Mit der Lösung öffnen',
    fr: 'Ouvrir avec la solution',
    it: 'Apri con la soluzione',
    en: 'Open with the solution',
  },
  copy: { de: 'Adresse kopieren', fr: 'Copier l’adresse', it: 'Copia l’indirizzo', en: 'Copy the address' },
  copied: { de: 'Kopiert', fr: 'Copié', it: 'Copiato', en: 'Copied' },
  copyFailed: {
    de: 'Der Browser lässt das Kopieren nicht zu. Das ist die Adresse:',
    fr: 'Le navigateur ne permet pas la copie. Voici l’adresse :',
    it: 'Il browser non permette di copiare. Ecco l’indirizzo:',
    en: 'The browser does not allow copying. This is the address:',
  },
  unknown: {
    de: 'Diesen Kurs gibt es hier nicht.',
    fr: 'Ce parcours n’existe pas ici.',
    it: 'Questo percorso qui non esiste.',
    en: 'There is no such course here.',
  },
  seed: { de: 'Zahl', fr: 'Nombre', it: 'Numero', en: 'Number' },
  seedHint: {
    de: 'Dieselbe Zahl gibt überall denselben Kurs: Schreib sie auf, und alle fahren das Gleiche.',
    fr: 'Le même nombre donne partout le même parcours : note-le, et tout le monde fait le même trajet.',
    it: 'Lo stesso numero dà ovunque lo stesso percorso: scrivilo, e tutti faranno lo stesso tragitto.',
    en: 'The same number gives the same course everywhere: write it down, and everyone drives the same.',
  },
  seedProblem: {
    de: 'Nur ganze Zahlen von 1 bis 999999',
    fr: 'Seulement des nombres entiers de 1 à 999999',
    it: 'Solo numeri interi da 1 a 999999',
    en: 'Only whole numbers from 1 to 999999',
  },
  newSeed: { de: 'Neue Zahl', fr: 'Nouveau nombre', it: 'Nuovo numero', en: 'New number' },
  size: { de: 'Grösse', fr: 'Taille', it: 'Grandezza', en: 'Size' },
} as const satisfies Readonly<Record<string, Texts>>;

export const kindTexts: Readonly<Record<CourseKind, Texts>> = {
  free: { de: 'Frei', fr: 'Libre', it: 'Libero', en: 'Free' },
  line: { de: 'Linie', fr: 'Ligne', it: 'Linea', en: 'Line' },
  drive: { de: 'Fahren', fr: 'Trajet', it: 'Guida', en: 'Driving' },
  obstacles: { de: 'Hindernisse', fr: 'Obstacles', it: 'Ostacoli', en: 'Obstacles' },
  maze: { de: 'Labyrinth', fr: 'Labyrinthe', it: 'Labirinto', en: 'Maze' },
  blocks: { de: 'Klötze', fr: 'Blocs', it: 'Blocchi', en: 'Blocks' },
};

export const levelTexts: Readonly<Record<CourseLevel, Texts>> = {
  1: { de: 'leicht', fr: 'facile', it: 'facile', en: 'easy' },
  2: { de: 'mittel', fr: 'moyenne', it: 'media', en: 'medium' },
  3: { de: 'schwer', fr: 'difficile', it: 'difficile', en: 'hard' },
};

export const sizeTexts: Readonly<Record<RandomSize, Texts>> = {
  s: { de: 'klein', fr: 'petite', it: 'piccola', en: 'small' },
  m: { de: 'mittel', fr: 'moyenne', it: 'media', en: 'medium' },
  l: { de: 'gross', fr: 'grande', it: 'grande', en: 'large' },
};

/** What random courses are called, and what they say about themselves. */
export const randomTexts: Readonly<
  Record<RandomKind, { readonly title: Texts; readonly name: Texts; readonly text: Texts; readonly task: Texts }>
> = {
  maze: {
    title: { de: 'Zufälliges Labyrinth', fr: 'Labyrinthe au hasard', it: 'Labirinto a caso', en: 'Random maze' },
    name: {
      de: 'Labyrinth {seed}, {size}',
      fr: 'Labyrinthe {seed}, taille {size}',
      it: 'Labirinto {seed}, misura {size}',
      en: 'Maze {seed}, {size}',
    },
    text: {
      de: 'Aus der Zahl {seed}: dieselbe Zahl gibt überall dasselbe Labyrinth.',
      fr: 'Fait du nombre {seed} : le même nombre donne partout le même labyrinthe.',
      it: 'Fatto dal numero {seed}: lo stesso numero dà ovunque lo stesso labirinto.',
      en: 'Made from the number {seed}: the same number gives the same maze everywhere.',
    },
    task: {
      de: 'Finde den Weg zum Ziel. Es gibt genau einen, und eine schwarze Linie zeigt dir, dass du da bist.',
      fr: 'Trouve le chemin jusqu’à l’arrivée. Il y en a exactement un, et une ligne noire te montre que tu y es.',
      it: 'Trova la via fino all’arrivo. Ce n’è esattamente una, e una linea nera ti dice che ci sei.',
      en: 'Find the way to the target. There is exactly one, and a black line tells you that you are there.',
    },
  },
  track: {
    title: { de: 'Zufällige Linie', fr: 'Ligne au hasard', it: 'Linea a caso', en: 'Random line' },
    name: {
      de: 'Linie {seed}, {size}',
      fr: 'Ligne {seed}, taille {size}',
      it: 'Linea {seed}, misura {size}',
      en: 'Line {seed}, {size}',
    },
    text: {
      de: 'Aus der Zahl {seed}: dieselbe Zahl gibt überall dieselbe Linie.',
      fr: 'Faite du nombre {seed} : le même nombre donne partout la même ligne.',
      it: 'Fatta dal numero {seed}: lo stesso numero dà ovunque la stessa linea.',
      en: 'Made from the number {seed}: the same number gives the same line everywhere.',
    },
    task: {
      de: 'Folge der Linie eine Runde lang: durch die Kontrollpunkte 1 bis 3 und zurück zum Start.',
      fr: 'Suis la ligne pendant un tour : par les points de contrôle 1 à 3 et retour au départ.',
      it: 'Segui la linea per un giro: per i punti di controllo da 1 a 3 e di nuovo alla partenza.',
      en: 'Follow the line for one lap: past checkpoints 1 to 3 and back to the start.',
    },
  },
};
