import type { Texts } from '#core/languages';
import { randomMaze } from '#scene/random/maze';
import { randomTrack } from '#scene/random/track';
import type { Scene } from '#scene/scene';

import { LANGUAGES, type Language } from '../../../kit/i18n/texts';
import type { Course, CourseLevel, CourseTexts } from '#catalogue/course';
import {
  type RandomKind,
  type RandomSize,
  type RandomWish,
  randomId,
} from '../../../session/work/catalogue/random-wish';
import courseGalleryWords from '../words/courses';

/** Ids of the ready courses whose programs a random course is opened and solved with. */
const models: Readonly<Record<RandomKind, string>> = { maze: 'large-maze', track: 's-bends' };

/** Chosen: small ones fit beside the program on a tablet; in large ones a robot drives for minutes. */
const mazes = { s: { columns: 4, rows: 3 }, m: { columns: 6, rows: 4 }, l: { columns: 8, rows: 6 } } as const;
const CELL_MM = 250;
const tracks = {
  s: { bends: 6, size: [1200, 900] },
  m: { bends: 9, size: [1600, 1200] },
  l: { bends: 14, size: [2000, 1400] },
} as const;
const levels: Readonly<Record<RandomKind, Readonly<Record<RandomSize, CourseLevel>>>> = {
  maze: { s: 2, m: 3, l: 3 },
  track: { s: 1, m: 2, l: 3 },
};

/**
 * The course that a number stands for.
 *
 * @param language of its name and description, which go into the file
 * @param courses the ready courses: one of them supplies its programs
 */
export function randomCourse(wish: RandomWish, language: Language, courses: readonly Course[]): Course {
  const { kind, size } = wish;
  const model = courses.find(({ id }) => id === models[kind]);
  if (model === undefined) throw new Error(`There is no course ${models[kind]}.`);
  const texts = textsIn(wish);
  const { program, solution } = model;
  const scene = sceneOf(wish, texts[language]);
  const level = levels[kind][size];
  const about = kind === 'maze' ? 'maze' : 'line';
  return {
    id: randomId(wish),
    place: null,
    level,
    kind: about,
    scene,
    program,
    solution,
    texts,
    devices: [],
    isRandom: true,
  };
}

/** Its texts by language, each made when it is asked for: the words of others than the shown one need not be there. */
const textsIn = (wish: RandomWish): Course['texts'] =>
  Object.defineProperties(
    {},
    Object.fromEntries(LANGUAGES.map((one) => [one, { get: () => textsOf(wish, one), enumerable: true }])),
  ) as Course['texts'];

function sceneOf({ kind, size, seed }: RandomWish, { name, text, task }: CourseTexts): Scene {
  const words = { name, description: `${task} ${text}` };
  return kind === 'maze'
    ? randomMaze({ seed, ...mazes[size], cellMm: CELL_MM }, words)
    : randomTrack({ seed, ...tracks[size] }, words);
}

function textsOf({ kind, size, seed }: RandomWish, language: Language): CourseTexts {
  const fill = (texts: Texts): string =>
    texts[language].replace('{seed}', String(seed)).replace('{size}', courseGalleryWords.sizes[size][language]);
  const { name, text, task } = courseGalleryWords.randomCourses[kind];
  return { name: fill(name), text: fill(text), task: fill(task) };
}
