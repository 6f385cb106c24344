import { afterEach, describe, expect, it, vi } from 'vitest';
import { effectScope, nextTick, shallowRef, type EffectScope } from 'vue';

import type { Snapshot } from '#simulation/snapshot';
import { RowWriter } from '#tape/rows/row-writer';

import type { RunModel } from '../../session/run/run-model';
import { useLookBack, type LookBack } from './look-back';

const STEP_US = 20_000;
let scope: EffectScope | null = null;
const frames: ((nowMs: number) => void)[] = [];

/** Looks back at a run of that many moments, 20 ms apart; the clock stands at 0. */
async function lookingAt(moments: number, speed = 1) {
  const writer = new RowWriter();
  for (let count = 1; count <= moments; count++) {
    const moment = { timeUs: count * STEP_US, buttons: { a: count === 2 } };
    writer.add(moment);
  }
  const asked = shallowRef<{ readonly timeUs: number } | null>(null);
  const past = shallowRef<Snapshot | null>({ timeUs: moments * STEP_US } as Snapshot);
  const lookAt = vi.fn();
  const recording = { pieces: [writer.finish()!], setup: null, count: shallowRef(1), asked, ask: (it: null) => void (asked.value = it) }; // prettier-ignore
  const run = {
    ...{ past, recording: shallowRef(recording), nowUs: shallowRef(moments * STEP_US) },
    ...{ look: { show: (moment: Snapshot) => void (past.value = moment) }, trails: { lookAt } },
  } as unknown as RunModel;
  vi.stubGlobal('requestAnimationFrame', (next: (nowMs: number) => void) => frames.push(next));
  vi.stubGlobal('cancelAnimationFrame', () => void frames.splice(0));
  vi.spyOn(performance, 'now').mockReturnValue(0);
  scope = effectScope();
  const back: LookBack = scope.run(() => useLookBack(run, () => speed))!;
  await nextTick();
  return { back, asked, lookAt, shownMs: () => (past.value?.timeUs ?? 0) / 1000 };
}

afterEach(() => {
  scope?.stop();
  frames.splice(0);
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

describe('looking back at a run', () => {
  it('begins at its end, and knows what happened', async () => {
    const { back } = await lookingAt(5);
    expect([back.atUs.value, back.endUs.value]).toEqual([100_000, 100_000]);
    expect(back.marks.value.map(({ kind, timeUs }) => [kind, timeUs])).toEqual([['pressA', 40_000]]);
  });

  it('shows the last moment that is not later than the time that is wished', async () => {
    const { back, shownMs, lookAt } = await lookingAt(5);
    back.seek(70_000);
    expect([back.atUs.value, shownMs()]).toEqual([70_000, 60]);
    expect(lookAt).toHaveBeenLastCalledWith(60_000);
  });

  it('leads neither before the start nor beyond the end', async () => {
    const { back, shownMs } = await lookingAt(5);
    back.seek(900_000);
    expect([back.atUs.value, shownMs()]).toEqual([100_000, 100]);
    back.seek(-5);
    expect(back.atUs.value).toBe(0);
  });

  it('plays backwards at the speed of the run, and stands at the start', async () => {
    const { back } = await lookingAt(5, 2);
    back.play(-1);
    frames.shift()!(30);
    expect([back.atUs.value, back.playing.value]).toEqual([40_000, -1]);
    frames.shift()!(60);
    expect([back.atUs.value, back.playing.value, frames]).toEqual([0, 0, []]);
  });

  it('plays from the start again where it stands at the end', async () => {
    const { back } = await lookingAt(5);
    back.play(1);
    frames.shift()!(10);
    expect([back.atUs.value, back.playing.value]).toEqual([10_000, 1]);
  });

  it('stops playing when another moment is wished, or one is asked for elsewhere', async () => {
    const { back, asked, shownMs } = await lookingAt(5);
    back.play(-1);
    back.seek(60_000);
    expect([back.playing.value, frames]).toEqual([0, []]);
    back.play(-1);
    asked.value = { timeUs: 40_000 };
    await nextTick();
    expect([back.playing.value, back.atUs.value, shownMs()]).toEqual([0, 40_000, 40]);
  });
});
