import { describe, expect, it, vi } from 'vitest';

import { fetchedOnce, lastMadeOf, memo, memoOf, once } from './memo';

describe('what a module remembers', () => {
  it('is made when it is first asked for, and once', () => {
    const make = vi.fn(() => ({}));
    const thing = once(make);
    expect(make).not.toHaveBeenCalled();
    expect(thing()).toBe(thing());
    expect(make).toHaveBeenCalledOnce();
  });

  it('is fetched again after a try that failed, and once it has come, not any more', async () => {
    const fetch = vi.fn<() => Promise<string>>().mockRejectedValueOnce(new Error('offline')).mockResolvedValue('there');
    const thing = fetchedOnce(fetch);
    await expect(thing()).rejects.toThrow('offline');
    expect([await thing(), await thing()]).toEqual(['there', 'there']);
    expect(fetch).toHaveBeenCalledTimes(2);
  });

  it('is fetched once by two who ask before it has come', async () => {
    const fetch = vi.fn(() => Promise.resolve({}));
    const thing = fetchedOnce(fetch);
    const [one, other] = await Promise.all([thing(), thing()]);
    expect(one).toBe(other);
    expect(fetch).toHaveBeenCalledOnce();
  });

  it('is made once for each name, also where it is undefined', () => {
    const make = vi.fn((name: string) => (name === 'none' ? undefined : name.length));
    const lengthOf = memo(make);
    expect(['one', 'three', 'one', 'none', 'none'].map(lengthOf)).toEqual([3, 5, 3, undefined, undefined]);
    expect(make).toHaveBeenCalledTimes(3);
  });

  it('is made once for each object, and for an equal one again', () => {
    const make = vi.fn(({ width }: { width: number }) => ({ half: width / 2 }));
    const halfOf = memoOf(make);
    const box = { width: 4 };
    expect(halfOf(box)).toBe(halfOf(box));
    expect(halfOf({ width: 4 })).not.toBe(halfOf(box));
    expect(make).toHaveBeenCalledTimes(2);
  });

  it('is made again when what it is made by has changed', () => {
    const make = vi.fn((box: { width: number }, zoom: number) => box.width * zoom);
    const sizeOf = lastMadeOf(make);
    const box = { width: 4 };
    expect([sizeOf(box, 1), sizeOf(box, 1), sizeOf(box, 2), sizeOf(box, 1)]).toEqual([4, 4, 8, 4]);
    expect(make).toHaveBeenCalledTimes(3);
  });
});
