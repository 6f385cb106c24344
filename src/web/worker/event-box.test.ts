import { describe, expect, it } from 'vitest';

import { createEventBox } from './event-box';

const packet = (timeUs: number) => ({ timeUs, bytes: [1] });

describe('the box of events', () => {
  it('gives what happened once, in its order, and nothing when nothing happened', () => {
    const box = createEventBox();
    expect(box.take()).toBeNull();
    box.outlets.radio?.(packet(1));
    box.outlets.radio?.(packet(2));
    expect(box.take()?.radio).toEqual([packet(1), packet(2)]);
    expect(box.take()).toBeNull();
  });

  it('keeps the newest packets of a program that sends without end, and counts the rest', () => {
    const box = createEventBox();
    for (let i = 1; i <= 100_000; i++) box.outlets.radio?.(packet(i));
    const events = box.take();
    expect(events?.radio.at(-1)).toEqual(packet(100_000));
    expect(events?.radio.length).toBeLessThanOrEqual(400);
    expect((events?.radioDropped ?? 0) + (events?.radio.length ?? 0)).toBe(100_000);
  });

  it('forgets rows of the data log that were deleted before anyone saw them', () => {
    const box = createEventBox();
    box.outlets.log?.({ type: 'row', headings: ['a'], values: ['1'], timeUs: 1 });
    box.outlets.log?.({ type: 'clear', timeUs: 2 });
    expect(box.take()?.log).toEqual([{ type: 'clear', timeUs: 2 }]);
  });
});
