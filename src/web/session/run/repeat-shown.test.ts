import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { createNotices } from '../../kit/notices';
import { repeatShown } from './repeat-shown';
import type { RunModel } from './run-model';
import type { Repeated, RepeatAnswer } from './worker/look/repeat';

const wish = { setup: {} as never, untilUs: 60_000_000, untilProgramEnds: false };
const repeated = { result: {}, first: {} } as Repeated;

/** A run that is repeated by a worker for which the test speaks. */
async function repeating(): Promise<{
  readonly notices: ReturnType<typeof createNotices>;
  readonly answer: Promise<Repeated | null>;
  readonly say: (data: RepeatAnswer) => void;
  readonly terminate: ReturnType<typeof vi.fn>;
}> {
  const terminate = vi.fn();
  const worker = { postMessage: () => undefined, terminate, onmessage: null, onerror: null } as unknown as Worker;
  const engine = { createWorker: () => worker, firmware: () => Promise.resolve({} as WebAssembly.Module) };
  const notices = createNotices();
  const answer = repeatShown({ notices, run: { engine } as unknown as RunModel }, wish, (percent) => `${percent} %`);
  await vi.waitFor(() => expect(worker.onmessage).not.toBeNull());
  return { notices, answer, say: (data) => worker.onmessage?.({ data } as MessageEvent), terminate };
}
const at = (seconds: number): RepeatAnswer => ({ type: 'repeating', nowUs: seconds * 1_000_000 });

describe('a kept run that is run again, for people', () => {
  let nowMs = 0;
  beforeEach(() => {
    nowMs = 0;
    vi.spyOn(performance, 'now').mockImplementation(() => nowMs);
  });
  afterEach(() => {
    vi.restoreAllMocks();
  });

  it('is not talked about when it is there within half a second', async () => {
    const { notices, answer, say } = await repeating();
    nowMs = 499;
    say(at(30));
    expect(notices.current.value).toBeNull();
    say({ type: 'repeated', repeated });
    expect(await answer).toBe(repeated);
  });

  it('says how far it is in steps of ten percent, or every five seconds, and is silent in the end', async () => {
    const { notices, answer, say } = await repeating();
    const told = (ms: number, seconds: number): unknown => {
      nowMs = ms;
      say(at(seconds));
      return notices.current.value?.values?.['text'];
    };
    expect(told(500, 6)).toBe('10 %');
    expect(told(700, 11.9)).toBe('10 %');
    expect(told(900, 12)).toBe('20 %');
    expect(told(5899, 13)).toBe('20 %');
    expect(told(5900, 13)).toBe('21 %');
    say({ type: 'repeated', repeated });
    expect(await answer).toBe(repeated);
    expect(notices.current.value).toBeNull();
  });

  it('can be given up: then its worker ends', async () => {
    const { notices, answer, say, terminate } = await repeating();
    nowMs = 600;
    say(at(1));
    notices.current.value?.action?.run();
    expect(await answer).toBeNull();
    expect([notices.current.value, terminate.mock.calls.length]).toEqual([null, 1]);
  });

  it('leaves what somebody else has said meanwhile', async () => {
    const { notices, answer, say } = await repeating();
    nowMs = 600;
    say(at(1));
    notices.show({ kind: 'ok', key: 'notice.text' });
    say({ type: 'failed', message: 'no memory' });
    await expect(answer).rejects.toThrow('no memory');
    expect(notices.current.value?.kind).toBe('ok');
  });
});
