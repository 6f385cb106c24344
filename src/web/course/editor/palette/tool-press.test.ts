import { describe, expect, it } from 'vitest';

import { ToolPress } from './tool-press';

const at = (x: number, y: number, timeStamp: number, pointerId = 1) => ({
  pointerId,
  clientX: x,
  clientY: y,
  timeStamp,
  button: 0,
});

describe('a tap on a tool', () => {
  it('chooses when the finger leaves, without waiting for a click that may not come', () => {
    const press = new ToolPress();
    press.down('wall', at(20, 20, 1000));
    expect(press.up('wall', at(22, 21, 1080))).toBe(true);
  });

  it('is not heard twice when the click comes all the same, even above another tool', () => {
    const press = new ToolPress();
    press.down('wall', at(20, 20, 1000));
    press.up('wall', at(20, 20, 1080));
    expect(press.click({ detail: 1, timeStamp: 1085 })).toBe(false);
    expect(press.click({ detail: 1, timeStamp: 3000 })).toBe(true);
  });

  it('is a click for the keyboard and for screen readers', () => {
    const press = new ToolPress();
    expect(press.click({ detail: 0, timeStamp: 10 })).toBe(true);
    press.down('wall', at(20, 20, 1000));
    press.up('wall', at(20, 20, 1080));
    expect(press.click({ detail: 0, timeStamp: 1090 })).toBe(true);
  });

  it('is none when the finger scrolls, rests for the hint, or leaves on another tool', () => {
    const press = new ToolPress();
    press.down('wall', at(20, 20, 1000));
    expect(press.up('wall', at(40, 20, 1080))).toBe(false);
    press.down('wall', at(20, 20, 2000));
    press.cancel();
    expect(press.up('wall', at(20, 20, 2080))).toBe(false);
    press.down('wall', at(20, 20, 3000));
    expect(press.up('wall', at(20, 20, 3700))).toBe(false);
    press.down('wall', at(20, 20, 4000));
    expect(press.up('maze', at(22, 20, 4080))).toBe(false);
    press.down('wall', at(20, 20, 5000));
    expect(press.up('wall', at(20, 20, 5080, 2))).toBe(false);
    press.down('wall', { ...at(20, 20, 6000), button: 2 });
    expect(press.up('wall', at(20, 20, 6080))).toBe(false);
  });
});
