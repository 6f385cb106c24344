import { describe, expect, it } from 'vitest';

import type { Texts } from '#core/languages';
import { parseScene } from '#scene/parse';
import { serializeScene } from '#scene/serialize';
import { LANGUAGES } from '../../../kit/i18n/texts';
import { projectOf } from '#catalogue/course';
import { withSolution } from '#catalogue/read-courses';
import { courses } from '#catalogue/courses';
import { isUntouched } from '../../../session/work/catalogue/examples';
import { randomCourse } from './random-course';
import {
  newSeed,
  randomId,
  randomKinds,
  randomSizes,
  readRandomId,
  readSeed,
  type RandomWish,
} from '../../../session/work/catalogue/random-wish';
import { robotNameOfCourse } from './use-course-opening';
import courseGalleryWords from '../words/courses';

const slots = (text: string): string[] => (text.match(/\{\w+\}/g) ?? []).sort();

describe('the words of the gallery of courses', () => {
  const { kinds, levels, sizes, list, randomCourses, ...gallery } = courseGalleryWords;
  const all: readonly Texts[] = [
    ...[gallery, kinds, levels, sizes, list].flatMap((texts) => Object.values<Texts>(texts)),
    ...Object.values(randomCourses).flatMap((texts) => Object.values(texts)),
  ];

  it('leave the same places open in German and English, and no German text has an ß', () => {
    expect(all.length).toBeGreaterThan(40);
    for (const { de, en } of all) {
      expect(slots(en), en).toEqual(slots(de));
      expect(de).not.toContain('ß');
    }
  });
});

describe('every course in the gallery', () => {
  it('names its robot', () => {
    for (const course of courses)
      expect(robotNameOfCourse(course), course.id).toMatch(/^(Maqueen (Lite|Plus V[23])|Calli:bot)$/);
  });
});

describe('a course made from a number', () => {
  const wishes: readonly RandomWish[] = randomKinds.flatMap((kind) =>
    randomSizes.map((size) => ({ kind, size, seed: 4711 })),
  );

  it('has an address that leads back to it; addresses of others are no number', () => {
    for (const wish of wishes) expect(readRandomId(randomId(wish))).toEqual(wish);
    expect(randomId(wishes[1]!)).toBe('maze-m-4711');
    for (const id of [
      '',
      'slalom',
      'maze',
      'maze-m',
      'maze-x-1',
      'maze-m-0',
      'maze-m-01',
      'maze-m-1000000',
      'maze-m-1x',
    ])
      expect(readRandomId(id), id).toBeNull();
  });

  it('is the same wherever it is made, and says its number in the name and the description of its file', () => {
    for (const wish of wishes)
      for (const language of LANGUAGES) {
        const { scene, texts } = randomCourse(wish, language, courses);
        expect(randomCourse(wish, language, courses).scene).toEqual(scene);
        expect(scene.name).toBe(texts[language].name);
        expect(scene.name).toContain('4711');
        expect(scene.description).toContain('4711');
        expect(parseScene(serializeScene(scene))).toEqual({ scene });
      }
    expect(randomCourse(wishes[1]!, 'de', courses).scene.name).toBe('Labyrinth 4711, mittel');
    expect(randomCourse(wishes[1]!, 'en', courses).scene.objects).toEqual(
      randomCourse(wishes[1]!, 'de', courses).scene.objects,
    );
  });

  it('belongs to the pupil and no ready course, and its programs count as untouched', () => {
    for (const wish of wishes)
      for (const language of LANGUAGES)
        for (const course of [
          randomCourse(wish, language, courses),
          withSolution(randomCourse(wish, language, courses)),
        ]) {
          const project = projectOf(course, language);
          expect(project.course).toBeNull();
          // What says the same as the solution may be the pupil's own.
          const isStart = course.program === randomCourse(wish, language, courses).program;
          expect(isUntouched(project), course.id).toBe(isStart);
        }
  });

  it('takes whole numbers of at most six digits, and nothing else', () => {
    expect(['1', ' 4711 ', '999999', '007'].map(readSeed)).toEqual([1, 4711, 999_999, 7]);
    for (const text of ['', 'abc', '0', '1000000', '-5', '1.5', '1e3', '12a']) expect(readSeed(text), text).toBeNull();
  });

  it('is another one for a new number', () => {
    for (let seed = 1; seed < 200; seed += 1) {
      expect(newSeed(1000 + seed)).not.toBe(1000 + seed);
      expect(readRandomId(randomId({ kind: 'maze', size: 's', seed: newSeed() }))).not.toBeNull();
    }
  });
});
