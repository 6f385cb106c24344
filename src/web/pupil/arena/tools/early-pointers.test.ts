import { describe, expect, it } from 'vitest';
import { createEarlyPointers, type GestureEvent } from './early-pointers';
import type { PointerNews } from './tool-pointers';

const event = (offsetX: number): PointerEvent =>
  ({ pointerId: 1, pointerType: 'touch', button: 0, offsetX, offsetY: 5, currentTarget: null }) as PointerEvent;

/** Tools that record their calls. */
function told() {
  const heard: string[] = [];
  const hear = (name: GestureEvent) => (news: PointerNews) => void heard.push(`${name} ${news.offsetX}`);
  const names = ['pointerdown', 'pointermove', 'pointerup', 'pointercancel'] as const;
  const tools = Object.fromEntries(names.map((name) => [name, hear(name)])) as Record<
    GestureEvent,
    (news: PointerNews) => void
  >;
  return { heard, tools };
}

describe('a gesture that begins before the tools have come', () => {
  it('is told to them as a whole, in its order, and once', () => {
    const early = createEarlyPointers();
    const { heard, tools } = told();
    early.note('pointermove', event(1));
    early.note('pointerdown', event(2));
    early.note('pointermove', event(3));
    early.note('pointerup', event(4));
    early.replay(tools);
    early.replay(tools);
    expect(heard).toEqual(['pointerdown 2', 'pointermove 3', 'pointerup 4']);
  });

  it('is forgotten when the tools cannot be had or another one is chosen', () => {
    const early = createEarlyPointers();
    const { heard, tools } = told();
    early.note('pointerdown', event(2));
    early.forget();
    early.replay(tools);
    expect(heard).toEqual([]);
  });
});
