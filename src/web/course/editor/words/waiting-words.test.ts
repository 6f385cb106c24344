import { beforeAll, describe, expect, it } from 'vitest';

import { applyEdit, type SceneEdit } from '#scene/edit';
import { defaultScene, type SceneObject } from '#scene/scene';

import { setLanguage } from '../../../kit/i18n';
import { waitingWords } from './waiting-words';

beforeAll(async () => {
  globalThis.document ??= { documentElement: {} } as Document;
  await setLanguage('de');
});

const wall = (id: string): SceneObject => ({ type: 'wall', id, from: [0, 0], to: [100, 0], thickness: 10 });
const fixed: SceneObject = { type: 'fixed-block', id: 'f', at: [300, 300], size: [50, 50], angle: 0 };
const start = { ...defaultScene(), objects: [wall('old')] };
const told = (...edits: readonly SceneEdit[]): string => waitingWords(start, edits.reduce(applyEdit, start));
const moveStart: SceneEdit = { type: 'robot', robot: { at: [100, 100] } };

describe('the words for what waits for the next start', () => {
  it('name what was added, moved or taken away', () => {
    expect(told({ type: 'add', objects: [wall('a')] })).toBe('Wand: gilt erst, wenn du neu startest.');
    expect(told({ type: 'add', objects: [wall('a'), wall('b')] })).toBe('Wände: gilt erst, wenn du neu startest.');
    expect(told({ type: 'remove', ids: ['old'] }, moveStart)).toBe('Wand, Start: gilt erst, wenn du neu startest.');
  });

  it('leave the names out where there are many', () =>
    expect(
      told({ type: 'add', objects: [wall('a'), fixed] }, moveStart, { type: 'course', changes: { size: [500, 500] } }),
    ).toBe('Gilt erst, wenn du neu startest.'));
});
