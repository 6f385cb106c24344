import { describe, expect, it } from 'vitest';
import type { SceneEdit } from './edit';
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
const worked = (): History => steps.reduce(advanced, historyOf(defaultScene()));

/** The courses that can be gone back to, the nearest first. */
function earlier(history: History): readonly Scene[] {
  return history.past.length === 0 ? [] : [undone(history).present, ...earlier(undone(history))];
}

/** The course as it comes back out of the browser's storage: equal, but not the same objects. */
function reloaded(scene: Scene): Scene {
  const parsed = parseScene(serializeScene(scene));
  if (!('scene' in parsed)) throw new Error(parsed.problem);
  return parsed.scene;
}

describe('the history of a course that is kept', () => {
  it('takes the same steps back and forth after the page was loaded anew', () => {
    const before = undone(undone(worked()));
    const after = historyFromText(historyToText(before, 100_000), reloaded(before.present));
    expect(after.present).toEqual(before.present);
    expect(earlier(after)).toEqual(earlier(before));
    expect(after.future.map(({ edit }) => edit)).toEqual(before.future.map(({ edit }) => edit));
    expect(redone(redone(after)).present).toEqual(worked().present);
    expect(redone(redone(undone(undone(after)))).present).toEqual(before.present);
  });

  it('shares what the courses have in common', () => {
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
    const after = historyFromText(text, reloaded(before.present));
    expect(after.past.length).toBeGreaterThan(0);
    expect(after.past.length).toBeLessThan(6);
    expect(earlier(after)).toEqual(earlier(before).slice(0, after.past.length));
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
    expect(earlier(half)).toEqual(earlier(before).slice(0, half.past.length));
  });

  it('is read as earlier versions kept it: an object put back together with the one below it', () => {
    const present = reloaded(undone(worked()).present);
    const [s2, b] = present.objects;
    const back = [{ type: 'replace', changes: [{ id: 's2', by: [wall('a'), s2, { ...line, id: 's3' }] }] }];
    const forth = [{ type: 'clear' }, { type: 'add', objects: [b, s2] }];
    const of = /"of":("[^"]+")/.exec(historyToText(historyOf(present), 0))![1]!;
    const kept = `{"version":1,"of":${of},"back":${JSON.stringify(back)},"forth":${JSON.stringify(forth)}}`;
    const history = historyFromText(kept, present);
    expect(undone(history).present.objects.map(({ id }) => id)).toEqual(['a', 's2', 's3', 'b']);
    expect(redone(undone(history)).present).toEqual(present);
    expect(redone(redone(history)).present.objects).toEqual([b, s2]);
    expect(undone(undone(redone(redone(history)))).present).toEqual(present);
  });
});
