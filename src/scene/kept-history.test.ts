import { describe, expect, it } from 'vitest';
import { applyEdit, type SceneEdit } from './edit';
import { advanced, historyOf, redone, undone, type History } from './history';
import { historyFromText, historyToText } from './kept-history';
import { parseScene } from './parse';
import { defaultScene, type Scene, type SceneObject } from './scene';
import { serializeScene } from './serialize';

const wall = (id: string): SceneObject => ({ type: 'wall', id, from: [0, 0], to: [100, 0], thickness: 10 });
const line: SceneObject = { type: 'stroke', id: 's', points: [[0, 0], [90, 90]], width: 20, color: 'black' }; // prettier-ignore
const steps: readonly SceneEdit[] = [
  { type: 'add', objects: [wall('a'), line, wall('b')] },
  { type: 'replace', changes: [{ id: 's', by: [{ ...line, id: 's2' }, { ...line, id: 's3' }] }] }, // prettier-ignore
  { type: 'robot', robot: { at: [300, 300], heading: 90 } },
  { type: 'course', changes: { name: 'Meine', task: { seconds: 30, noTouch: true } } },
  { type: 'remove', ids: ['a', 's3'] },
  { type: 'clear' },
];
const worked = (): History =>
  steps.reduce((history, edit) => advanced(history, applyEdit(history.present, edit)), historyOf(defaultScene()));

/** The course as it comes back out of the browser's storage: equal, but not the same objects. */
function reloaded(scene: Scene): Scene {
  const parsed = parseScene(serializeScene(scene));
  if (!('scene' in parsed)) throw new Error(parsed.problem);
  return parsed.scene;
}

describe('the way of a course that is kept', () => {
  it('takes the same steps back and forth after the page was loaded anew', () => {
    const before = undone(undone(worked()));
    const after = historyFromText(historyToText(before, 100_000), reloaded(before.present));
    expect(after).toEqual(before);
    expect(redone(redone(after)).present).toEqual(worked().present);
  });

  it('shares what the courses have in common, so that a step back tells a run of little', () => {
    const before = undone(worked());
    const after = historyFromText(historyToText(before, 100_000), reloaded(before.present));
    const [b, s2] = [after.present.objects.find(({ id }) => id === 'b'), after.present.objects.find(({ id }) => id === 's2')]; // prettier-ignore
    expect(undone(after).present.objects).toContain(b);
    expect(undone(after).present.objects).toContain(s2);
  });

  it('leaves out the furthest steps where there is no room', () => {
    const before = worked();
    const text = historyToText(before, 600);
    expect(text.length).toBeLessThan(800);
    const { past } = historyFromText(text, reloaded(before.present));
    expect(past.length).toBeGreaterThan(0);
    expect(past.length).toBeLessThan(6);
    expect(past).toEqual(before.past.slice(-past.length));
  });

  it('is not taken for that of another course, and damaged gives what can be used', () => {
    const before = undone(worked());
    const text = historyToText(before, 100_000);
    const other = { ...before.present, name: 'Andere' };
    expect(historyFromText(text, other)).toEqual(historyOf(other));
    for (const broken of ['', 'null', '[]', text.slice(0, -1), text.replace('"version":1', '"version":9')])
      expect(historyFromText(broken, before.present)).toEqual(historyOf(before.present));
    const half = historyFromText(text.replace('"robot"', '"robots"'), before.present);
    expect(half.past.length).toBeLessThan(before.past.length);
    expect(half.past).toEqual(before.past.slice(before.past.length - half.past.length));
  });
});
