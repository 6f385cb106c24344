import { describe, expect, it } from 'vitest';
import type { Point } from '#scene/scene';
import { blockTool } from './block-tool';
import { contextOf, course, drag, freely, newObjects, used } from '../testing/desk';
import type { Drag, ToolOptions } from './tool';

const put = (one: Drag, options: Partial<ToolOptions> = {}) =>
  newObjects(course(), used(blockTool, one, contextOf(course(), options)));

describe('block', () => {
  it('is put by a tap with its middle on the 10 mm grid, in the chosen size', () => {
    expect(put(drag([303, 298]), { blockSize: [60, 40] })).toEqual([
      { type: 'block', id: 'block-1', at: [300, 300], size: [60, 40], angle: 0 },
    ]);
  });

  it('is put by a trembling finger as by a tap', () => {
    expect(put(drag([303, 298], [305, 299], [302, 297]))).toMatchObject([{ at: [300, 300], size: [50, 50] }]);
  });

  it('gets the size of a drag, in either direction', () => {
    expect(put(drag([100, 100], [300, 180]))).toMatchObject([{ at: [200, 140], size: [200, 80] }]);
    expect(put(drag([300, 180], [100, 100]))).toMatchObject([{ at: [200, 140], size: [200, 80] }]);
  });

  it('is at least 10 mm wide', () => {
    expect(put(drag([100, 100], [300, 101]))).toMatchObject([{ size: [200, 10] }]);
  });

  it('takes any millimetre when it is free', () => {
    expect(put(freely(drag([303, 298])))).toMatchObject([{ at: [303, 298] }]);
  });

  it('is as high as the tool is set to, whatever it is; what is usual for its kind is left out', () => {
    for (const block of ['block', 'fixed-block', 'spikes', 'mover'] as const) {
      expect(put(drag([300, 300]), { block, blockHeight: 30 })).toMatchObject([{ type: block, height: 30 }]);
      expect('height' in (put(drag([300, 300]), { block })[0] ?? {})).toBe(false);
    }
    expect('height' in (put(drag([300, 300]), { block: 'spikes', blockHeight: 50 })[0] ?? {})).toBe(false);
  });

  it('has the colour that the tool is set to, if its kind may have one', () => {
    expect(put(drag([300, 300]), { blockColor: 'red' })).toMatchObject([{ type: 'block', color: 'red' }]);
    expect(put(drag([300, 300]), { block: 'fixed-block', blockColor: 'red' })).toMatchObject([{ color: 'red' }]);
    for (const block of ['spikes', 'mover'] as const)
      expect('color' in (put(drag([300, 300]), { block, blockColor: 'red' })[0] ?? {})).toBe(false);
    expect('color' in (put(drag([300, 300]))[0] ?? {})).toBe(false);
  });

  it('may be fixed or have spikes', () => {
    expect(put(drag([300, 300]), { block: 'fixed-block' })).toMatchObject([
      { type: 'fixed-block', id: 'fixed-block-1' },
    ]);
    expect(put(drag([300, 300]), { block: 'spikes' })).toMatchObject([{ type: 'spikes', id: 'spikes-1' }]);
  });

  it('is put only once by two taps on the same place', () => {
    const once = used(blockTool, drag([303, 298]), contextOf(course()));
    expect(blockTool.edit(drag([302, 301]), contextOf(once))).toBeNull();
    expect(used(blockTool, drag([302, 301]), contextOf(once, { block: 'spikes' })).objects).toHaveLength(2);
    expect(used(blockTool, drag([302, 301]), contextOf(once, { blockShape: 'round' })).objects).toHaveLength(2);
    expect(used(blockTool, drag([322, 301]), contextOf(once)).objects).toHaveLength(2);
  });

  it('is not put outside the arena', () => {
    expect(put(drag([1300, 300]))).toEqual([]);
    expect(put(drag([-40, -40], [200, 200]))).toEqual([]);
  });
});

describe('mover', () => {
  const mover = { block: 'mover', moverSpeed: 150, moverSpiked: true } as const;

  it('goes from where the drag began to where it ended, with the chosen speed', () => {
    expect(put(drag([300, 300], [303, 600]), mover)).toEqual([
      {
        type: 'mover',
        id: 'mover-1',
        at: [300, 300],
        to: [300, 600],
        size: [50, 50],
        angle: 0,
        speed: 150,
        spiked: true,
      },
    ]);
  });

  it('goes 200 mm to the right when it is tapped, or to the left near the right edge', () => {
    expect(put(drag([300, 300]), mover)).toMatchObject([{ at: [300, 300], to: [500, 300] }]);
    expect(put(drag([1150, 300]), mover)).toMatchObject([{ at: [1150, 300], to: [950, 300] }]);
  });

  it('keeps its direction when it is dragged out of the arena, also from beside the grid', () => {
    expect(put(drag([1100, 500], [1600, 990]), mover)).toMatchObject([{ to: [1200, 600] }]);
    expect(put({ ...drag([303, 298], [497, 291]), reachMm: 1 }, mover)).toMatchObject([
      { at: [303, 298], to: [497, 298] },
    ]);
  });

  it('never stands still', () => {
    expect(put(freely(drag([300, 300], [320, 300], [301, 300])), mover)).toMatchObject([{ to: [500, 300] }]);
  });

  it('is round by a tap, where it is set so; a mover is never a polygon', () => {
    expect(put(drag([300, 300]), { blockShape: 'round' })).toMatchObject([{ size: [50, 50], round: true }]);
    expect(put(drag([300, 300]), { block: 'mover', blockShape: 'round' })).toMatchObject([{ round: true }]);
    expect(put(drag([300, 300]), { block: 'mover', blockShape: 'polygon' })[0]).not.toHaveProperty('corners');
  });

  it('is the polygon whose outline is drawn, closed by a straight line', () => {
    const ell = drag([100, 100], [200, 100], [300, 100], [300, 200], [200, 200], [200, 300], [100, 300]);
    expect(put(ell, { blockShape: 'polygon' })).toMatchObject([
      {
        ...{ at: [200, 200], size: [200, 200], angle: 0 },
        corners: [[0, 0], [200, 0], [200, 100], [100, 100], [100, 200], [0, 200]], // prettier-ignore
      },
    ]);
  });

  it('is the polygon around an outline that crosses itself, and a triangle in the box of a straight drag', () => {
    const eight = drag([100, 100], [200, 200], [200, 100], [100, 200]);
    expect(put(eight, { blockShape: 'polygon' })).toMatchObject([{ at: [150, 150], size: [100, 100] }]);
    expect(put(eight, { blockShape: 'polygon' })[0]).toHaveProperty('corners.length', 4);
    expect(put(drag([100, 100], [200, 160]), { blockShape: 'polygon' })).toMatchObject([
      { at: [150, 130], size: [100, 60], corners: [[0, 0], [2, 0], [1, 2]] }, // prettier-ignore
    ]);
  });

  describe('as a polygon that is set corner by corner', () => {
    const square = [[100, 100], [300, 100], [300, 300], [100, 300]] as const; // prettier-ignore
    const byTaps = (...places: readonly Point[]) => ({ ...drag(...places), corners: places.length - 1 });
    const context = contextOf(course(), { blockShape: 'polygon' });

    it('goes on from a tap to the tap on its first corner', () => {
      expect(blockTool.goesOn?.(drag([100, 100]), context)).toBe(true);
      expect(blockTool.goesOn?.(byTaps(...square), context)).toBe(true);
      expect(blockTool.goesOn?.(byTaps(...square, [100, 100]), context)).toBe(false);
    });

    it('is the polygon through the corners, however far it has come', () => {
      expect(put(byTaps(...square, [100, 100]), { blockShape: 'polygon' })).toMatchObject([
        { at: [200, 200], size: [200, 200], corners: [[0, 0], [200, 0], [200, 200], [0, 200]] }, // prettier-ignore
      ]);
      expect(put(byTaps(...square.slice(0, 3)), { blockShape: 'polygon' })[0]).toHaveProperty('corners.length', 3);
      expect(put(drag([100, 100]), { blockShape: 'polygon' })).toEqual([]);
      expect(put(byTaps([100, 100], [300, 100]), { blockShape: 'polygon' })).toEqual([]);
    });

    it('shows its line meanwhile, and where a tap ends it', () => {
      const marks = blockTool.marks?.(byTaps(...square), context, false) ?? [];
      expect(marks.map(({ type }) => type)).toEqual(['lasso', 'snap', 'snap']);
    });

    it('is drawn in one go by a drag, and never by a mover', () => {
      expect(blockTool.goesOn?.(drag([100, 100], [300, 100]), context)).toBe(false);
      expect(blockTool.goesOn?.(drag([100, 100]), contextOf(course(), { block: 'mover', blockShape: 'polygon' }))).toBe(false); // prettier-ignore
    });
  });
});
