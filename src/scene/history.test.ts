import { describe, expect, it } from 'vitest';
import { advanced, HISTORY_STEPS, historyOf, redone, undone, type History } from './history';
import { defaultScene, type Scene } from './scene';

const named = (name: string): Scene => ({ ...defaultScene(), name });
const [a, b, c] = [named('a'), named('b'), named('c')];
const ways = (history: History): string =>
  [history.past, [history.present], history.future].map((scenes) => scenes.map(({ name }) => name).join('')).join('|');

describe('the history of a course', () => {
  const abc = advanced(advanced(historyOf(a), b), c);

  it('goes back step by step and forth again', () => {
    expect(ways(abc)).toBe('ab|c|');
    expect(ways(undone(abc))).toBe('a|b|c');
    expect(ways(undone(undone(abc)))).toBe('|a|bc');
    expect(ways(redone(undone(undone(abc))))).toBe('a|b|c');
    expect(redone(redone(undone(undone(abc)))).present).toBe(c);
  });

  it('gives up what was taken back when something new is done', () => {
    expect(ways(advanced(undone(undone(abc)), named('d')))).toBe('a|d|');
  });

  it('ends at its ends', () => {
    expect(ways(undone(historyOf(a)))).toBe('|a|');
    expect(ways(redone(abc))).toBe('ab|c|');
  });

  it('takes the same scene for no step, and keeps what was taken back', () => {
    const back = undone(abc);
    expect(advanced(back, back.present)).toBe(back);
  });

  it('keeps the last 1000 steps', () => {
    let history = historyOf(a);
    for (let step = 1; step <= HISTORY_STEPS + 5; step++) history = advanced(history, named(String(step)));
    expect(history.past).toHaveLength(1000);
    expect(history.past[0]?.name).toBe('5');
    while (history.past.length > 0) history = undone(history);
    expect(history.present.name).toBe('5');
    expect(history.future).toHaveLength(1000);
  });
});
