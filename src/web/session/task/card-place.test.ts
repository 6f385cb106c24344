import { describe, expect, it } from 'vitest';

import { cardPlace, type Area } from './card-place';

const area = (left: number, top: number, right: number, bottom: number): Area => ({ left, top, right, bottom });
const laptop = area(8, 68, 1358, 760);
const arena = area(700, 68, 1358, 540);

describe('the place of the task’s card', () => {
  it('is beside the arena, above a console that reaches below the arena', () => {
    const around = { panes: laptop, arena, kept: null, isAlone: false };
    expect(cardPlace({ ...around, console: area(8, 548, 1358, 760) })).toEqual({
      ...{ kind: 'over', area: area(8, 68, 692, 540) },
    });
  });

  it('takes the room of a console that ends beside the arena', () => {
    const around = {
      panes: laptop,
      arena: area(700, 68, 1358, 760),
      console: area(8, 548, 692, 760),
      kept: null,
      isAlone: false,
    };
    expect(cardPlace(around)).toEqual({ kind: 'over', area: area(8, 68, 692, 760) });
  });

  it('leaves a part that stays in sight free, if both have room', () => {
    const around = { panes: laptop, arena, console: area(8, 548, 1358, 760), isAlone: false };
    expect(cardPlace({ ...around, kept: area(8, 340, 392, 540) }).area).toEqual(area(8, 68, 692, 332));
    expect(cardPlace({ ...around, kept: area(8, 270, 392, 540) }).area).toEqual(area(8, 68, 692, 540));
  });

  it('is above an arena that has the whole width', () => {
    const tablet = area(8, 68, 812, 1172);
    const around = {
      panes: tablet,
      arena: area(8, 500, 812, 950),
      console: area(8, 958, 812, 1172),
      kept: null,
      isAlone: false,
    };
    expect(cardPlace(around)).toEqual({ kind: 'over', area: area(8, 68, 812, 492) });
  });

  it('is a sheet below the arena of a phone, and beside it on a phone held across', () => {
    const upright = area(0, 56, 390, 784);
    expect(cardPlace({ panes: upright, arena: upright, console: null, kept: null, isAlone: false })).toEqual({
      ...{ kind: 'sheet', area: area(0, 347, 390, 784) },
    });
    const across = area(0, 56, 844, 330);
    expect(cardPlace({ panes: across, arena: across, console: null, kept: null, isAlone: false })).toEqual({
      ...{ kind: 'beside', area: area(0, 56, 388, 330) },
    });
  });

  it('is beside an arena that fills the screen', () => {
    const screen = area(0, 0, 1920, 1080);
    expect(cardPlace({ panes: screen, arena: screen, console: null, kept: null, isAlone: true })).toEqual({
      ...{ kind: 'beside', area: area(0, 0, 420, 1080) },
    });
  });
});
