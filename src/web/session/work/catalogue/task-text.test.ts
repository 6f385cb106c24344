import { describe, expect, it } from 'vitest';

import { inEvery } from '#core/words';
import { defaultScene, sceneDefaults, type Scene, type TaskCard } from '#scene/scene';

import { hasWords, taskText } from './task-text';

const sceneWith = (card: Partial<TaskCard>, description = 'Fahr los.'): Scene => ({
  ...defaultScene(),
  name: 'Parken',
  description,
  task: { seconds: null, noTouch: false, card: { ...sceneDefaults.card, ...card } },
});
const ready = { texts: inEvery((language) => ({ name: `Name ${language}`, text: '', task: `Task ${language}` })) };

describe('the words of a task', () => {
  it('are name and description of a course that says nothing else', () => {
    const scene = { ...defaultScene(), name: 'Parken', description: 'Fahr los.' };
    expect(taskText(scene, null, 'de')).toEqual({ title: 'Parken', text: 'Fahr los.', hints: [], picture: '' });
  });

  it('are those of a ready course in the language of the reader', () => {
    expect(taskText(defaultScene(), ready, 'it')).toMatchObject({ title: 'Name it', text: 'Task it' });
  });

  it('are those of the card, in the language of the reader where there is one', () => {
    const fr = { language: 'fr', title: 'Se garer', text: 'Démarre.', hints: ['Doucement.'] };
    const scene = sceneWith({ language: 'de', title: 'Einparken', hints: ['Langsam.'], translations: [fr] });
    expect(taskText(scene, null, 'fr')).toMatchObject({ title: 'Se garer', text: 'Démarre.', hints: ['Doucement.'] });
    for (const language of ['de', 'en'] as const)
      expect(taskText(scene, null, language)).toMatchObject({
        title: 'Einparken',
        text: 'Fahr los.',
        hints: ['Langsam.'],
      });
  });

  it('fall back part by part where a translation has gaps', () => {
    const gap = { language: 'fr', title: '', text: 'Démarre.', hints: [] };
    expect(taskText(sceneWith({ hints: ['Langsam.'], translations: [gap] }), null, 'fr')).toMatchObject({
      ...{ title: 'Parken', text: 'Démarre.', hints: ['Langsam.'] },
    });
  });

  it('are there with a text, a hint or a picture', () => {
    const shown = (scene: Scene) => hasWords(taskText(scene, null, 'de'));
    expect(shown(defaultScene())).toBe(false);
    expect(shown(sceneWith({}, ' \n'))).toBe(false);
    expect(shown(sceneWith({ hints: ['x'] }, ''))).toBe(true);
    expect(shown(sceneWith({ picture: 'data:image/png;base64,AAAA' }, ''))).toBe(true);
    expect(shown(sceneWith({}))).toBe(true);
  });
});
