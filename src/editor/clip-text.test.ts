import { describe, expect, it } from 'vitest';
import { serializeScene } from '#scene/serialize';
import { full, sceneOf } from '#scene/testing/full-scene';
import { clipOf, clipText } from './clip-text';
import { block, course, wall } from './testing/desk';

describe('copied objects as text', () => {
  it('come back as they were, of every kind', () => {
    const { objects } = sceneOf(full);
    expect(clipOf(clipText({ objects }))).toEqual({ objects });
  });

  it('are told from everything else that a clipboard may hold', () => {
    expect(clipOf('from microbit import *')).toBeNull();
    expect(clipOf('')).toBeNull();
    expect(clipOf(serializeScene(course(block('b', [1, 1]))))).toBeNull();
    expect(clipOf('parcours-objects')).toBeNull();
    expect(clipOf('{"format": "parcours-objects"}')).toBeNull();
    expect(clipOf(clipText({ objects: [] }))).toBeNull();
  });

  it('are checked like a course file: what is damaged or made up is not taken', () => {
    const text = clipText({ objects: [wall('w', [0, 0], [100, 0])] });
    expect(clipOf(text.replace('[100, 0]', '[100, 1e9]'))).toBeNull();
    expect(clipOf(text.slice(0, -9))).toBeNull();
  });
});
