import { describe, expect, it } from 'vitest';
import type { SceneEdit } from './edit';
import { advanced, HISTORY_CHARACTERS, HISTORY_STEPS, historyOf, redone, undone, type History } from './history';
import { defaultScene, type Scene } from './scene';

const start: Scene = { ...defaultScene(), name: 'a' };
const naming = (name: string): SceneEdit => ({ type: 'course', changes: { name } });
/** All courses that can be reached, `a|b|c`: past, present, future. */
function ways(history: History): string {
  let [past, future] = ['', ''];
  for (let at = history; at.past.length > 0; past = at.present.name + past) at = undone(at);
  for (let at = history; at.future.length > 0; future += at.present.name) at = redone(at);
  return [past, history.present.name, future].join('|');
}

describe('the history of a course', () => {
  const abc = advanced(advanced(historyOf(start), naming('b')), naming('c'));

  it('goes back step by step and forth again', () => {
    expect(ways(abc)).toBe('ab|c|');
    expect(ways(undone(abc))).toBe('a|b|c');
    expect(ways(undone(undone(abc)))).toBe('|a|bc');
    expect(ways(redone(undone(undone(abc))))).toBe('a|b|c');
    expect(redone(redone(undone(undone(abc))))).toEqual(abc);
  });

  it('holds the edits and what takes them back, no courses', () => {
    expect(abc.past).toMatchObject([
      { edit: naming('b'), inverse: naming('a') },
      { edit: naming('c'), inverse: naming('b') },
    ]);
    expect(undone(abc).future).toEqual(abc.past.slice(1));
  });

  it('gives up what was taken back when something new is done', () => {
    expect(ways(advanced(undone(undone(abc)), naming('d')))).toBe('a|d|');
  });

  it('ends at its ends', () => {
    expect(ways(undone(historyOf(start)))).toBe('|a|');
    expect(ways(redone(abc))).toBe('ab|c|');
  });

  it('takes an edit that changes nothing for no step, and keeps what was taken back', () => {
    const back = undone(abc);
    expect(advanced(back, naming('b'))).toBe(back);
  });

  it('keeps the last 1000 steps', () => {
    let history = historyOf(start);
    for (let step = 1; step <= HISTORY_STEPS + 5; step++) history = advanced(history, naming(String(step)));
    expect(history.past).toHaveLength(1000);
    while (history.past.length > 0) history = undone(history);
    expect(history.present.name).toBe('5');
    expect(history.future).toHaveLength(1000);
  });

  it('keeps fewer where each is large: 33 pictures of 1.5 million characters', () => {
    const levels = 'A'.repeat(1_500_000);
    let history = historyOf(start);
    for (let x = 1; x <= 40; x++)
      history = advanced(history, {
        type: 'course',
        changes: { background: { at: [x, 0], size: [100, 100], cells: [4, 3], levels, picture: '' } },
      });
    expect(history.past).toHaveLength(33);
    expect(history.past.reduce((sum, { characters }) => sum + characters, 0)).toBeLessThan(HISTORY_CHARACTERS);
    expect(history.present.background?.at).toEqual([40, 0]);
  });
});
