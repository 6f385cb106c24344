import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { lateDoor } from './late-door';

/** A door whose code can be fetched from the given try on. */
function doorFrom(firstGood: number) {
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
  const outside = { post: () => undefined, nowMs: () => 0 };
  const listener = {
    onMissing: () => void (told.missing += 1),
    onLost: (message: unknown, why: string) => void lost.push([message, why]),
  };
  return { door: lateDoor(open, outside, listener), heard, lost, told };
}

describe('a door whose code is fetched when it is needed', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());
  const pass = (ms: number) => vi.advanceTimersByTimeAsync(ms);

  it('keeps what is said until it is there, in order', async () => {
    const { door, heard } = doorFrom(1);
    door.receive(1);
    door.receive(2);
    await pass(0);
    door.receive(3);
    expect(heard).toEqual([1, 2, 3]);
  });

  it('is fetched again where the network was gone for a moment, and nothing is lost', async () => {
    const { door, heard, lost, told } = doorFrom(3);
    door.receive('hello');
    await pass(3000);
    expect([heard, lost, told.missing]).toEqual([['hello'], [], 0]);
  });

  it('says that it is missing after some tries and answers what waited; the next message tries anew', async () => {
    const { door, heard, lost, told } = doorFrom(5);
    door.receive('hello');
    await pass(20_000);
    expect([told.tries, told.missing, lost]).toEqual([4, 1, [['hello', 'broken']]]);
    door.receive('hello again');
    await pass(0);
    expect(heard).toEqual(['hello again']);
  });

  it('says of the messages that are too many that they are lost', async () => {
    const { door, heard, lost } = doorFrom(1);
    for (let at = 0; at < 201; at += 1) door.receive(at);
    await pass(0);
    expect([heard.length, lost]).toEqual([200, [[200, 'busy']]]);
  });

  it('does nothing more once it is closed', async () => {
    const { door, heard, told } = doorFrom(2);
    door.receive('hello');
    await pass(0);
    door.close();
    door.receive('late');
    await pass(20_000);
    expect([told.tries, told.missing, heard]).toEqual([1, 0, []]);
    const opening = doorFrom(1);
    opening.door.close();
    await pass(0);
    expect(opening.told.closed).toBe(1);
  });
});
