import { describe, expect, it } from 'vitest';
import { wheelGesture, wheelPx, type WheelTurn } from './wheel-gesture';

const turn = (part: Partial<WheelTurn>): WheelTurn => ({
  deltaX: 0,
  deltaY: 0,
  deltaMode: 0,
  shiftKey: false,
  ctrlKey: false,
  metaKey: false,
  ...part,
});

describe('the wheel over the arena', () => {
  it('zooms in when it turns away and out when it turns near, three notches there and back to the same', () => {
    const near = wheelGesture(turn({ deltaY: 100 }));
    const away = wheelGesture(turn({ deltaY: -100 }));
    expect(near.type === 'zoom' && near.factor).toBeCloseTo(1 / 1.26, 2);
    expect(away.type === 'zoom' && near.type === 'zoom' && away.factor * near.factor).toBeCloseTo(1, 12);
  });

  it('moves the picture sideways with Shift, whichever of its numbers the browser fills', () => {
    expect(wheelGesture(turn({ deltaY: 100, shiftKey: true }))).toEqual({ type: 'pan', byPx: { x: -100, y: 0 } });
    expect(wheelGesture(turn({ deltaX: 100, shiftKey: true }))).toEqual({ type: 'pan', byPx: { x: -100, y: 0 } });
  });

  it('moves the picture when two fingers go across a trackpad', () => {
    expect(wheelGesture(turn({ deltaX: 30, deltaY: -4 }))).toEqual({ type: 'pan', byPx: { x: -30, y: 4 } });
  });

  it('zooms more per step when two fingers pinch a trackpad', () => {
    const pinch = wheelGesture(turn({ deltaY: -10, ctrlKey: true }));
    const wheel = wheelGesture(turn({ deltaY: -10 }));
    expect(pinch.type === 'zoom' && wheel.type === 'zoom' && Math.log(pinch.factor) / Math.log(wheel.factor)).toBeCloseTo(3, 9); // prettier-ignore
  });

  it('counts lines and pages as Firefox sends them, and never zooms by more than 2 at once', () => {
    expect(wheelPx(3, 1)).toBe(99);
    expect(wheelGesture(turn({ deltaY: -3, deltaMode: 2 }))).toEqual({ type: 'zoom', factor: 2 });
  });
});
