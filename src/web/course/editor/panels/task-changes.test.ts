import { describe, expect, it } from 'vitest';

import { defaultScene, sceneDefaults, type Scene } from '#scene/scene';

import { wordsIn, withCard, withHelp, withStars, withWords } from './task-changes';

const course: Scene = { ...defaultScene(), name: 'Parken', description: 'Los.' };
const after = (scene: Scene, changes: object): Scene => ({ ...scene, ...changes });

describe('the task as a teacher writes it', () => {
  it('is the description of the course in the first language: without more there is no card', () => {
    expect(withWords(course, 'de', 'de', { text: 'Fahr.' })).toEqual({ description: 'Fahr.' });
  });

  it('has a card as soon as it says more, and none when that is taken away again', () => {
    const titled = after(course, withWords(course, 'de', 'de', { title: 'Einparken' }));
    expect(titled.task.card).toEqual({ ...sceneDefaults.card, title: 'Einparken' });
    expect(after(titled, withWords(titled, 'de', 'de', { title: '' })).task).toEqual(course.task);
  });

  it('says which language the first is when a second one comes, and forgets it when that goes', () => {
    const both = after(course, withWords(course, 'fr', 'de', { text: 'Démarre.' }));
    expect(both.task.card).toMatchObject({
      language: 'de',
      translations: [{ language: 'fr', title: '', text: 'Démarre.', hints: [] }],
    });
    expect(wordsIn(both, 'fr', 'it', 'Los.').text).toBe('Démarre.');
    expect(wordsIn(both, 'de', 'it', 'Los.').text).toBe('Los.'); // German stays first, whichever language is written
    expect(wordsIn(both, 'it', 'it', 'Los.').text).toBe('');
    expect(after(both, withWords(both, 'fr', 'it', { text: '' })).task).toEqual(course.task);
  });

  it('keeps the order of the translations when one is changed', () => {
    const two = ['fr', 'it'].reduce((scene, it) => after(scene, withWords(scene, it, 'de', { text: it })), course);
    const changed = after(two, withWords(two, 'fr', 'de', { hints: ['a'] }));
    expect(changed.task.card?.translations.map(({ language }) => language)).toEqual(['fr', 'it']);
    expect(changed.task.card?.translations[0]).toEqual({ language: 'fr', title: '', text: 'fr', hints: ['a'] });
  });

  it('allows help and gives stars, or says nothing of them', () => {
    const { task } = course;
    const both = withHelp(withHelp(task, 'edits', true), 'hand', true);
    expect(both.allows).toEqual(['hand', 'edits']);
    expect(withHelp(withHelp(both, 'edits', false), 'hand', false)).toEqual(task);
    expect(withStars(withStars(task, [30, 20]), null)).toEqual(task);
    expect(withCard({ ...task, stars: [30, 20] }, { ...sceneDefaults.card, title: 'x' })).toMatchObject({
      stars: [30, 20],
    });
  });
});
