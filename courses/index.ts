import closedLineProgram from './closed-line/main.py?raw';
import closedLineScene from './closed-line/scene.json?raw';
import emptyProgram from './empty/main.py?raw';
import emptyScene from './empty/scene.json?raw';
import smallMazeProgram from './small-maze/main.py?raw';
import smallMazeScene from './small-maze/scene.json?raw';

/** A ready course: a scene and a program that masters it. */
export interface Course {
  /** The folder's name. */
  readonly id: string;
  readonly title: { readonly de: string; readonly en: string };
  /** The text of its course file, for `parseScene`. */
  readonly scene: string;
  /** The text of its main.py. */
  readonly program: string;
}

/** All ready courses in the order in which they are offered. */
export const courses: readonly Course[] = [
  { id: 'empty', title: { de: 'Leere Arena', en: 'Empty arena' }, scene: emptyScene, program: emptyProgram },
  {
    id: 'closed-line',
    title: { de: 'Geschlossene Linie', en: 'Closed line' },
    scene: closedLineScene,
    program: closedLineProgram,
  },
  {
    id: 'small-maze',
    title: { de: 'Kleines Labyrinth', en: 'Small maze' },
    scene: smallMazeScene,
    program: smallMazeProgram,
  },
];
