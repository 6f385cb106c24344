import { describe, expect, it } from 'vitest';

import { createEventBox } from './event-box';

const packet = (timeUs: number) => ({ timeUs, group: 0, bytes: [1] });

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

  it('gives the trail of the robot once, x and y alternately, with two NaN where it was lifted', () => {
    const box = createEventBox();
    box.outlets.trail?.({ x: 1, y: 2 });
    box.outlets.trail?.(null);
    box.outlets.trail?.({ x: 30, y: 40 });
    expect(box.take()).toBeNull();
    expect(box.takeTrail()).toEqual([1, 2, NaN, NaN, 30, 40]);
    expect(box.takeTrail()).toEqual([]);
  });

  it('keeps the newest 60 m of a trail that nobody asks for', () => {
    const box = createEventBox();
    for (let i = 1; i <= 100_000; i++) box.outlets.trail?.({ x: i, y: 0 });
    const trail = box.takeTrail();
    expect(trail.length).toBeLessThanOrEqual(60_000);
    expect(trail.slice(-2)).toEqual([100_000, 0]);
  });

  it('forgets rows of the data log that were deleted before anyone saw them', () => {
    const box = createEventBox();
    box.outlets.log?.({ type: 'row', headings: ['a'], values: ['1'], timeUs: 1 });
    box.outlets.log?.({ type: 'clear', timeUs: 2 });
    expect(box.take()?.log).toEqual([{ type: 'clear', timeUs: 2 }]);
  });
});
