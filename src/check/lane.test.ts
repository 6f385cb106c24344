import { describe, expect, it } from 'vitest';
import { handInOfFiles } from './hand-in/read-hand-in';
import { Asker, Lane, START_MS, STUCK_MS, type CheckAnswer, type CheckRequest } from './lane';
import { unreadable } from './result';
import { sceneWith, targetAt, taskWith } from './testing/tasks';

const task = taskWith(sceneWith([targetAt(700, 450)]), { seconds: 2 });
const passed: CheckAnswer = { result: { ...unreadable([], { code: 'zip', params: {} }), passed: true, remarks: [] } };

/**
 * A lane, and the time that passes for it.
 *
 * @param answers what a thread, counted from 1, says at once to what it is asked; `null`: nothing
 */
function laneWith(answers: (thread: number, request: CheckRequest) => CheckAnswer | null, pulse = () => 0) {
  let started = 0;
  const watching = new Set<() => void>();
  const lane = new Lane(
    task,
    (heard) => {
      const thread = (started += 1);
      return {
        ask(request) {
          const answer = answers(thread, request);
          if (answer !== null) queueMicrotask(() => heard(answer));
        },
        pulse: () => ({ beat: pulse(), world: 0 }),
        stop: () => undefined,
      };
    },
    (_, act) => {
      watching.add(act);
      return () => watching.delete(act);
    },
  );
  const pass = async (looks: number): Promise<void> => {
    for (let look = 0; look < looks; look += 1) for (const act of watching) act();
    await settled();
  };
  return { lane, pass, started: () => started, watching: () => watching.size };
}

/** Enough looks at a thread for it to be stuck. */
const STUCK_LOOKS = STUCK_MS / 200 + 1;
const settled = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));
const nothing = handInOfFiles([]);

describe('a lane', () => {
  it('tries a hand-in once more whose thread gave no sign of life: the machine may have been busy', async () => {
    const { lane, pass, started } = laneWith((thread) => (thread === 1 ? null : passed));
    const result = lane.check(nothing);
    await pass(STUCK_LOOKS);
    expect((await result).passed).toBe(true);
    expect(started()).toBe(2);
  });

  it('asks once more where the code of a thread did not come, and blames no program then', async () => {
    const once = laneWith((thread) => (thread === 1 ? { unloaded: true } : passed));
    expect((await once.lane.check(nothing)).passed).toBe(true);
    const never = laneWith(() => ({ unloaded: true }));
    const { passed: hasPassed, remarks } = await never.lane.check(nothing);
    expect([hasPassed, remarks[0]?.params]).toEqual([false, { why: 'unloaded' }]);
    expect([once.started(), never.started()]).toEqual([2, 2]);
  });

  it('tells one that gives none a second time, and runs nothing of the world in which it was', async () => {
    const lost: CheckRequest['lost'][] = [];
    const { lane, pass, started } = laneWith((_, request) => {
      lost.push(request.lost);
      return request.lost === undefined ? null : passed;
    });
    const result = lane.check(nothing);
    await pass(STUCK_LOOKS);
    await pass(STUCK_LOOKS);
    await result;
    expect(lost).toEqual([undefined, undefined, { from: 0, reason: { code: 'stuck', params: {} } }]);
    expect(started()).toBe(3);
  });

  it('blames no program where the code does not come for the asking after one that was stuck', async () => {
    const { lane, pass } = laneWith((_, request) => (request.lost === undefined ? null : { unloaded: true }));
    const result = lane.check(nothing);
    await pass(STUCK_LOOKS);
    await pass(STUCK_LOOKS);
    expect((await result).remarks[0]?.params).toEqual({ why: 'unloaded' });
  });

  it('gives a run up that goes on, but slower than the real robot, after two minutes', async () => {
    let beat = 0;
    const lost: CheckRequest['lost'][] = [];
    const { lane, pass } = laneWith(
      (_, request) => {
        lost.push(request.lost);
        return request.lost === undefined ? null : passed;
      },
      () => (beat += 1),
    );
    const result = lane.check(nothing);
    await pass(5 * 119);
    expect(lost).toHaveLength(1);
    await pass(5 * 2);
    await result;
    expect(lost.at(-1)).toEqual({ from: 0, reason: { code: 'long', params: { seconds: 120 } } });
  });

  it('looks at no thread any more once it was stopped, and starts none', async () => {
    const { lane, pass, started, watching } = laneWith(() => null);
    void lane.check(nothing);
    lane.stop();
    expect(watching()).toBe(0);
    await pass(STUCK_LOOKS);
    expect(started()).toBe(1);
  });
});

describe('a thread that is still loading', () => {
  it('is not stuck for a minute; once it has begun, it is after ten seconds of silence', async () => {
    let beat = 0;
    let look = (): void => undefined;
    const asker = new Asker<string, string>(
      () => ({ ask: () => undefined, pulse: () => ({ beat, world: 0 }), stop: () => undefined }),
      (_, act) => {
        look = act;
        return () => undefined;
      },
      Infinity,
      START_MS,
    );
    const pass = (ms: number): void => Array.from({ length: ms / 200 }).forEach(() => look());
    let ended: string | null = null;
    const ask = (): void =>
      void asker.askOnce('').then((ending) => (ended = 'reason' in ending ? ending.reason.code : ending.result));
    ask();
    pass(START_MS);
    await settled();
    expect(ended).toBeNull();
    pass(200);
    await settled();
    expect(ended).toBe('stuck');
    ended = null;
    ask();
    beat = 1;
    pass(STUCK_MS);
    await settled();
    expect(ended).toBeNull();
    pass(400);
    await settled();
    expect(ended).toBe('stuck');
  });
});
