// @vitest-environment happy-dom
import { nextTick } from 'vue';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import type { Snapshot } from '#simulation/snapshot';
import type { Variables } from '#vm/debug/variables';
import { createPage, type TestPage } from '../../app/testing/page';
import { pictureOf, show, startRun } from '../../app/testing/run';
import type { Look, LookWish } from '../../session/run/look-client';
import { Past } from './past';

const nothing: Variables = { stack: [], globals: [] };
const lookOf = (timeUs: number, snapshot: Snapshot): Look => ({
  device: 0,
  timeUs,
  isLine: true,
  snapshot,
  variables: nothing,
});

/** A page with a run that has come to 1 s, and a worker that looks into it. */
async function opened() {
  const page: TestPage = createPage();
  const workers: { onmessage: ((event: MessageEvent) => void) | null }[] = [];
  const wishes: LookWish[] = [];
  const sent: string[] = [];
  let answer: Look | null = null;
  const createWorker = () => {
    const worker = {
      onmessage: null as ((event: MessageEvent) => void) | null,
      onerror: null,
      terminate: vi.fn(),
      postMessage(message: { readonly type: string; readonly ask?: number; readonly wish?: LookWish }) {
        sent.push(message.type);
        if (message.wish === undefined) return;
        wishes.push(message.wish);
        const data = { type: 'looked', ask: message.ask, look: answer };
        queueMicrotask(() => worker.onmessage?.({ data } as MessageEvent));
      },
    };
    workers.push(worker);
    return worker as never;
  };
  const tell = vi.fn();
  const engine = { createWorker, firmware: () => Promise.resolve({} as WebAssembly.Module) };
  const past = new Past({ ...page, engine }, tell);
  await startRun(page);
  await show(page, { timeUs: 1_000_000 });
  page.run.pause();
  const knowInputs = (): void => page.say({ type: 'inputs', inputs: [], nowUs: 0 });
  return { page, past, tell, workers, wishes, sent, knowInputs, answerWith: (look: Look | null) => (answer = look) };
}
let given: Awaited<ReturnType<typeof opened>>;
beforeEach(async () => (given = await opened()));

describe('the past of a run', () => {
  it('is gone back to line by line, each from the one that was found', async () => {
    const { page, past, tell, workers, wishes, knowInputs, answerWith } = given;
    answerWith(lookOf(900_000, pictureOf({ timeUs: 900_000 })));
    const first = past.back();
    knowInputs();
    await first;
    expect(page.run.past.value?.timeUs).toBe(900_000);
    answerWith(lookOf(800_000, pictureOf({ timeUs: 800_000 })));
    knowInputs(); // asked for again with each look: nothing new was done
    await past.back();
    expect(page.run.past.value?.timeUs).toBe(800_000);
    expect(wishes.map(({ at }) => [at.timeUs, at.isLine])).toEqual([
      [1_000_000, false],
      [900_000, true],
    ]);
    expect(tell).toHaveBeenCalledTimes(2);
    expect(workers).toHaveLength(1);
  });

  it('begins at the line where the run is held', async () => {
    const { page, past, wishes, knowInputs } = given;
    page.say({ type: 'held', device: 0, timeUs: 1_000_050 });
    await nextTick();
    const back = past.back();
    knowInputs();
    await back;
    expect(wishes[0]?.at).toEqual({ device: 0, timeUs: 1_000_050, isLine: true });
  });

  it('begins there also when another picture of that moment comes while it is gone back to', async () => {
    const { page, past, wishes, knowInputs } = given;
    page.say({ type: 'held', device: 0, timeUs: 1_000_000 });
    page.run.look.back();
    await show(page, { timeUs: 1_000_000 });
    const back = past.back();
    knowInputs();
    await back;
    expect(wishes[0]?.at).toEqual({ device: 0, timeUs: 1_000_000, isLine: true });
  });

  it('leaves out the line in whose midst it is: going back would not move', async () => {
    const { page, past, wishes, knowInputs } = given;
    await show(page, { timeUs: 1_000_000, position: { file: 'plus.py', line: 13, depth: 1 } });
    const back = past.back();
    knowInputs();
    await back;
    expect(wishes[0]).toMatchObject({ at: { isLine: false }, within: { file: 'plus.py', line: 13 } });
  });

  it('is made ready while nobody has asked anything', async () => {
    const { page, past, sent, knowInputs } = given;
    await past.prepare(); // nobody looks back
    page.run.look.back();
    const ready = past.prepare();
    knowInputs();
    await ready;
    expect(sent).toEqual(['look-into', 'look-near']);
  });

  it('has no line before the first: what is shown stays', async () => {
    const { page, past, tell, knowInputs, answerWith } = given;
    answerWith(null);
    const back = past.back();
    knowInputs();
    await back;
    expect(page.run.past.value?.timeUs).toBe(1_000_000);
    expect(tell).not.toHaveBeenCalled();
  });

  it('is stepped through as far as the run has come', async () => {
    const { page, past, wishes, knowInputs, answerWith } = given;
    page.run.look.back();
    page.run.look.at(500_000, pictureOf({ timeUs: 500_000 }));
    knowInputs();
    answerWith(lookOf(510_000, pictureOf({ timeUs: 510_000 })));
    await past.step('over');
    expect(wishes).toEqual([
      { kind: 'step', step: 'over', at: { device: 0, timeUs: 500_000, isLine: false }, untilUs: 1_000_000 },
    ]);
    expect(page.run.past.value?.timeUs).toBe(510_000);
  });

  it('is looked into for a host without the page overtaking it, which is told, too', async () => {
    const { page, past, tell, wishes, knowInputs, answerWith } = given;
    page.run.look.back();
    page.run.look.at(500_000, pictureOf({ timeUs: 500_000 }));
    knowInputs();
    const look = lookOf(500_000, pictureOf({ timeUs: 500_000 }));
    answerWith(look);
    const [found] = await Promise.all([past.momentOf(0), past.look()]);
    expect(found).toEqual(look);
    expect(wishes).toHaveLength(1);
    expect(tell).toHaveBeenCalledTimes(1);
  });

  it('does not tell the variables of a moment that is shown no more', async () => {
    const { page, past, tell, knowInputs, answerWith } = given;
    page.run.look.back();
    page.run.look.at(500_000, pictureOf({ timeUs: 500_000 }));
    knowInputs();
    answerWith(lookOf(500_000, pictureOf({ timeUs: 500_000 })));
    const look = past.look();
    page.run.look.at(600_000, pictureOf({ timeUs: 600_000 }));
    await look;
    expect(tell).not.toHaveBeenCalled();
  });
});
