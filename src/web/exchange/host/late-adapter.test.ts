import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { lateAdapter } from './late-adapter';

/** An adapter whose code can be fetched from the given attempt on. */
function adapterFrom(firstGood: number) {
  const heard: unknown[] = [];
  const lost: unknown[] = [];
  const told = { tries: 0, missing: 0, closed: 0 };
  const open = () => {
    told.tries += 1;
    if (told.tries < firstGood) return Promise.reject(new Error('offline'));
    return Promise.resolve({
      receive: (message: unknown) => void heard.push(message),
      close: () => void (told.closed += 1),
    });
  };
  const connection = { post: () => undefined, nowMs: () => 0 };
  const listener = {
    onMissing: () => void (told.missing += 1),
    onLost: (message: unknown, why: string) => void lost.push([message, why]),
  };
  return { adapter: lateAdapter(open, connection, listener), heard, lost, told };
}

describe('an adapter whose code is fetched when it is needed', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());
  const pass = (ms: number) => vi.advanceTimersByTimeAsync(ms);

  it('keeps what is said until it is there, in order', async () => {
    const { adapter, heard } = adapterFrom(1);
    adapter.receive(1);
    adapter.receive(2);
    await pass(0);
    adapter.receive(3);
    expect(heard).toEqual([1, 2, 3]);
  });

  it('is fetched again where the network was gone for a moment, and nothing is lost', async () => {
    const { adapter, heard, lost, told } = adapterFrom(3);
    adapter.receive('hello');
    await pass(3000);
    expect([heard, lost, told.missing]).toEqual([['hello'], [], 0]);
  });

  it('says that it is missing after some tries and answers what waited; the next message tries anew', async () => {
    const { adapter, heard, lost, told } = adapterFrom(5);
    adapter.receive('hello');
    await pass(20_000);
    expect([told.tries, told.missing, lost]).toEqual([4, 1, [['hello', 'broken']]]);
    adapter.receive('hello again');
    await pass(0);
    expect(heard).toEqual(['hello again']);
  });

  it('says of the messages that are too many that they are lost', async () => {
    const { adapter, heard, lost } = adapterFrom(1);
    for (let at = 0; at < 201; at += 1) adapter.receive(at);
    await pass(0);
    expect([heard.length, lost]).toEqual([200, [[200, 'busy']]]);
  });

  it('does nothing more once it is closed', async () => {
    const { adapter, heard, told } = adapterFrom(2);
    adapter.receive('hello');
    await pass(0);
    adapter.close();
    adapter.receive('late');
    await pass(20_000);
    expect([told.tries, told.missing, heard]).toEqual([1, 0, []]);
    const opening = adapterFrom(1);
    opening.adapter.close();
    await pass(0);
    expect(opening.told.closed).toBe(1);
  });
});
