import { describe, expect, it } from 'vitest';
import { handInOfFiles } from './hand-in/read-hand-in';
import { Lane, STUCK_MS } from './lane';

/** A lane whose threads never answer, and the time that passes for it. */
function silentLane() {
  let started = 0;
  const watching = new Set<() => void>();
  const lane = new Lane(
    [],
    () => {
      started += 1;
      return { ask: () => undefined, pulse: () => ({ beat: 0, world: 0 }), stop: () => undefined };
    },
    (_, act) => {
      watching.add(act);
      return () => watching.delete(act);
    },
  );
  const pass = (looks: number): void => {
    for (let look = 0; look < looks; look += 1) for (const act of watching) act();
  };
  return { lane, pass, started: () => started, watching: () => watching.size };
}

/** Enough looks at a thread for it to be stuck. */
const STUCK_LOOKS = STUCK_MS / 200 + 1;
const settled = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

describe('a lane', () => {
  it('replaces a thread that gives no sign of life', async () => {
    const { lane, pass, started } = silentLane();
    void lane.check(handInOfFiles([]));
    pass(STUCK_LOOKS);
    await settled();
    expect(started()).toBe(2);
  });

  it('that was stopped looks at no thread any more, and starts none', async () => {
    const { lane, pass, started, watching } = silentLane();
    void lane.check(handInOfFiles([]));
    lane.stop();
    expect(watching()).toBe(0);
    pass(STUCK_LOOKS);
    await settled();
    expect(started()).toBe(1);
  });
});
