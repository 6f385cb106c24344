import { describe, expect, it } from 'vitest';
import type { InputAction, InputEvent } from './input';
import { InputQueue } from './input-queue';

const a = (down: boolean): InputAction => ({ type: 'button', button: 'a', down });
const asSensor = (value: number): InputAction => ({ type: 'sensor', id: 'buttonA', value });
const pad = (down: boolean): InputAction => ({ type: 'touch', pad: 'pin0', down });
const text: InputAction = { type: 'serial', text: 'x' };

/** When actions take effect that are done live at these times, in ms; the queue is asked every 4 ms, as by a run. */
function effects(live: readonly (readonly [atMs: number, action: InputAction])[], inputs: readonly InputEvent[] = []) {
  const queue = new InputQueue(inputs);
  const done: (readonly [atMs: number, action: InputAction])[] = [];
  const rest = [...live];
  for (let nowMs = 0; nowMs <= 10_000; nowMs += 4) {
    for (let event = queue.takeDue(nowMs * 1000); event; event = queue.takeDue(nowMs * 1000))
      done.push([nowMs, event.action]);
    while (rest[0] && rest[0][0] < nowMs + 4) {
      const [atMs, action] = rest.shift()!;
      queue.add(action, atMs * 1000);
    }
  }
  return done;
}

const timesOf = (done: ReturnType<typeof effects>): number[] => done.map(([atMs]) => atMs);
const at = (atMs: number, ...actions: InputAction[]) => actions.map((action) => [atMs, action] as const);

describe('what is done to a run while it goes on', () => {
  it('takes effect at the next step, and a tap in one breath lasts 100 ms', () => {
    expect(effects(at(8, a(true), text, a(false)))).toEqual([[12, a(true)], [12, text], [108, a(false)]]); // prettier-ignore
  });

  it('is as long as the finger where that holds a button for 300 ms', () => {
    expect(timesOf(effects([...at(100, a(true)), ...at(400, a(false))]))).toEqual([104, 404]);
  });

  it('counts twice when it is tapped twice, with 60 ms between the two', () => {
    expect(timesOf(effects(at(0, a(true), a(false), a(true), a(false))))).toEqual([4, 100, 160, 260]);
  });

  it('is one button however it is pressed, and each button and pad has its own time', () => {
    const done = effects(at(0, asSensor(1), a(false), pad(true), pad(false), asSensor(1)));
    expect(done).toEqual([[4, asSensor(1)], [4, pad(true)], [100, a(false)], [100, pad(false)], [160, asSensor(1)]]); // prettier-ignore
  });

  it('is left out where it says nothing new', () => {
    expect(timesOf(effects(at(0, a(true), a(true), asSensor(0.7), a(false), a(false))))).toEqual([4, 100]);
  });

  it('ends as the last change says after 500 taps at the same moment, of which 7 count', () => {
    const taps = Array.from({ length: 500 }, () => [a(true), a(false)]).flat();
    const done = effects(at(0, ...taps));
    expect(done).toHaveLength(14);
    expect(done.at(-1)?.[1]).toEqual(a(false));
    const held = effects(at(0, ...taps, a(true)));
    expect(held.at(-1)?.[1]).toEqual(a(true));
    const letGo = effects([...at(0, ...taps, a(true)), ...at(5000, a(false))]);
    expect(letGo.at(-1)).toEqual([5004, a(false)]);
  });
});

describe('what is replayed', () => {
  it('keeps its times, however close they are', () => {
    const inputs = [a(true), a(false), a(true)].map((action, index) => ({ timeUs: 8000 * index, action }));
    expect(timesOf(effects([], inputs))).toEqual([0, 8, 16]);
  });

  it('is the change that a live one keeps its distance from', () => {
    const inputs = [{ timeUs: 1_000_000, action: a(true) }];
    expect(timesOf(effects(at(1010, a(false)), inputs))).toEqual([1000, 1100]);
  });

  it('comes in order of time, those of the same time in the order of the log', () => {
    const inputs = [
      { timeUs: 8000, action: a(false) },
      { timeUs: 4000, action: text },
      { timeUs: 8000, action: pad(true) },
    ];
    expect(effects([], inputs)).toEqual([[4, text], [8, a(false)], [8, pad(true)]]); // prettier-ignore
  });
});
