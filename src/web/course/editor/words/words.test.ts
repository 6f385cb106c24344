import { beforeAll, describe, expect, it } from 'vitest';

import type { SceneEdit } from '#scene/edit';
import { findProblems } from '#scene/rules';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';

import { setLanguage } from '../../../kit/i18n';
import { wordsFor } from './happened-words';
import { namesOf, whereText } from './object-words';
import { problemsOf, problemWords } from './problem-words';

// The texts are in the page's language.
beforeAll(async () => {
  globalThis.document ??= { documentElement: {} } as Document;
  await setLanguage('de');
});

const wall = (id: string): SceneObject => ({ type: 'wall', id, from: [100, 200], to: [405, 200], thickness: 10 });
const checkpoint = (number: number): SceneObject => ({
  type: 'checkpoint',
  id: `c${String(number)}`,
  at: [100, 100],
  size: [150, 150],
  angle: 0,
  round: false,
  number,
  blocks: 0,
});
const scene: Scene = { ...defaultScene(), objects: [wall('a'), checkpoint(2), wall('b')] };
const said = (edit: SceneEdit, type: 'edit' | 'undo' = 'edit'): string => wordsFor({ type, scene, edit });

describe('objects in words', () => {
  it('are counted by their kind, a checkpoint by its own number', () =>
    expect([...namesOf(scene).values()]).toEqual(['Wand 1', 'Kontrollpunkt 2', 'Wand 2']));
  it('say where they are in cm', () => {
    expect(whereText(wall('a'))).toBe('von 10 | 20 bis 40.5 | 20 cm');
    expect(whereText(checkpoint(1))).toBe('15 × 15 cm bei 10 | 10 cm');
  });
});

describe('what is said of an edit', () => {
  it('tells what was added and where', () =>
    expect(said({ type: 'add', objects: [wall('c')] })).toBe('Wand hinzugefügt bei 25.3 | 20 cm'));
  it('counts what was deleted', () => expect(said({ type: 'remove', ids: ['a', 'b'] })).toBe('2 Wände gelöscht'));
  it('names the last thing that was deleted; only clearing clears', () => {
    expect(said({ type: 'remove', ids: scene.objects.map(({ id }) => id) })).toBe('3 Dinge gelöscht');
    expect(said({ type: 'clear' })).toBe('Alles gelöscht');
  });
  it('tells where the start is now', () =>
    expect(said({ type: 'robot', robot: { at: [305, 400], heading: 90 } })).toBe(
      'Start bei 30.5 | 40 cm, Richtung 90 Grad',
    ));
  it('names what is taken back, not its reverse', () =>
    expect(said({ type: 'remove', ids: ['a'] }, 'undo')).toBe('Rückgängig: Wand gelöscht'));
  it('tells what is locked, and what was grouped', () => {
    const locked = { ...wall('a'), lock: true } as const;
    expect(said({ type: 'replace', changes: [{ id: 'a', by: [locked] }] })).toBe('Wand gesperrt');
    const groups = ['a', 'b'].map((id) => ({ id, by: [{ ...wall(id), group: 'g' }] }));
    expect(said({ type: 'replace', changes: groups })).toBe('2 Wände gruppiert');
    const chosen = {
      type: 'selected',
      scene: { ...scene, objects: [locked] },
      selection: { ids: ['a'], robot: false },
    };
    expect(wordsFor(chosen as never)).toBe('Gewählt: Wand 1, von 10 | 20 bis 40.5 | 20 cm, gesperrt');
  });
  it('tells what is selected', () =>
    expect(wordsFor({ type: 'selected', scene, selection: { ids: ['b'], robot: false } })).toBe(
      'Gewählt: Wand 2, von 10 | 20 bis 40.5 | 20 cm',
    ));
});

describe('problems of a course in words', () => {
  it('leave no gap open in their sentence', () => {
    const odd: Scene = {
      ...scene,
      objects: [
        ...scene.objects,
        wall('copy'),
        { type: 'fixed-block', id: 'f', at: [600, 450], size: [100, 100], angle: 0 },
        { type: 'block', id: 'inside', at: [600, 450], size: [50, 50], angle: 0 },
        { type: 'block', id: 'far', at: [9000, 450], size: [50, 50], angle: 0 },
        { type: 'mover', id: 'm', at: [200, 600], to: [200, 600], size: [50, 50], angle: 0, speed: 10, spiked: false },
        { ...checkpoint(2), id: 'twice' },
        { type: 'target', id: 't', at: [900, 200], size: [20, 20], angle: 0, round: false, number: 0, blocks: 9 },
        { type: 'forbidden', id: 'v', at: [600, 450], size: [200, 200], angle: 0, round: false, number: 0, blocks: 0 },
      ],
    };
    const problems = findProblems(odd, [[{ x: -30, y: -30 }, { x: 30, y: -30 }, { x: 30, y: 30 }, { x: -30, y: 30 }]]); // prettier-ignore
    const words = problems.map((problem) => problemWords(problem, odd));
    expect(new Set(problems.map(({ code }) => code)).size).toBeGreaterThanOrEqual(9);
    expect(words.filter((text) => /[{}]|: \.|^ | {2}|undefined/.test(text))).toEqual([]);
    expect(words).toContain('Am Start des Roboters steht etwas im Weg: Fester Block 1.');
  });

  it('say what lies twice, and how often', () => {
    const block = (id: string): SceneObject => ({ type: 'fixed-block', id, at: [900, 700], size: [50, 50], angle: 0 });
    const twice: Scene = { ...scene, objects: ['a', 'b', 'c'].map(wall).concat(block('f'), block('g')) };
    expect(findProblems(twice, []).map((problem) => problemWords(problem, twice))).toEqual([
      'Hier liegen 3 gleiche Wände übereinander.',
      'Hier liegen zwei gleiche feste Blöcke übereinander.',
    ]);
  });

  it('do not mind a line that was drawn twice: it looks and reads the same', () => {
    const line = (id: string): SceneObject => ({ type: 'stroke', id, points: [[100, 600], [300, 600]], width: 20, color: 'black' }); // prettier-ignore
    const twice: Scene = { ...scene, objects: [line('a'), line('b'), wall('c'), wall('d')] };
    expect(problemsOf(twice, []).map(({ ids }) => ids)).toEqual([['c', 'd']]); // prettier-ignore
  });
});

describe('clearing all in words', () => {
  it('is one thing, even where name and task go along', () => {
    const edit: SceneEdit = { type: 'all', edits: [{ type: 'clear' }, { type: 'course', changes: { name: 'x' } }] };
    expect(said(edit)).toBe('Alles gelöscht');
  });
});
