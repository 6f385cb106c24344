// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { unpackLevels } from '#scene/background';
import type { Background } from '#scene/scene';

import { createPage } from '../../../app/testing/page';
import { keyOn, press } from '../../../app/testing/editing';
import { mountOn, named } from '../../../app/testing/mount-on';
import PhotoFloor from './PhotoFloor.vue';
import { emptyPixels } from './pixels';

/** A white sheet of 100 × 80 pixels with a black line down its left quarter. */
function sheet() {
  const pixels = emptyPixels(100, 80);
  for (let at = 0; at < 100 * 80; at += 1) {
    const grey = at % 100 >= 20 && at % 100 < 30 ? 0 : 250;
    pixels.data.set([grey, grey, grey, 255], 4 * at);
  }
  return pixels;
}

describe('a picture that becomes the floor', () => {
  const opened = (isPhoto = true) => {
    const mounted = mountOn(createPage(), PhotoFloor, { opened: { pixels: sheet(), isPhoto }, arena: [1000, 800] });
    const floor = async (): Promise<Background> => {
      await press('Als Boden nehmen');
      return (mounted.emitted('take') ?? []).at(-1)?.[0] as Background;
    };
    /** The levels along the middle row of the floor. */
    const middle = async (): Promise<number[]> => {
      const made = await floor();
      const [across, up] = made.cells;
      return [...(unpackLevels(made) ?? [])].slice((up / 2) * across, (up / 2 + 1) * across);
    };
    return { mounted, floor, middle };
  };

  it('is line and bare floor for the sensors, as large as fits', async () => {
    const { floor, middle } = opened();
    expect(await floor()).toMatchObject({ at: [0, 0], size: [1000, 800], cells: [500, 400] });
    const levels = await middle();
    expect([levels[50], levels[125], levels[300]]).toEqual([15, 0, 15]);
    expect(new Set(levels)).toEqual(new Set([0, 15]));
  });

  it('keeps its greys where they are wanted, and does so at first with a drawing', async () => {
    const { mounted, middle } = opened(false);
    expect(mounted.get('[data-testid="steps-greys"]').attributes('aria-pressed')).toBe('true');
    expect(mounted.findAll('input[type="range"]')).toHaveLength(1); // without a threshold
    expect(new Set(await middle())).toEqual(new Set([0, 15]));
  });

  it('is cut by moving corners and sides with the arrow keys, fine with Shift, and told in words', async () => {
    const { mounted, floor } = opened();
    const corner = mounted.get('[data-testid="corner-0"]');
    expect(corner.attributes('aria-label')).toBe('Ecke oben links: 0 | 0 %');
    for (let step = 0; step < 10; step += 1) await keyOn(corner.element, 'ArrowRight');
    await keyOn(corner.element, 'ArrowDown', { shiftKey: true });
    expect(corner.attributes('aria-label')).toBe('Ecke oben links: 10 | 1 %');
    const right = named('Rechter Rand: 100 | 50 %');
    for (let step = 0; step < 20; step += 1) await keyOn(right, 'ArrowLeft');
    expect(right.getAttribute('aria-label')).toBe('Rechter Rand: 80 | 50 %');
    expect((await floor()).size[0]).toBeLessThan(800);
    await press('Ganzes Bild');
    expect(corner.attributes('aria-label')).toBe('Ecke oben links: 0 | 0 %');
  });

  it('is turned by quarters: the line on the left comes to lie above', async () => {
    const { floor } = opened();
    await press('Nach rechts drehen');
    const made = await floor();
    expect(made.size).toEqual([640, 800]);
    const levels = unpackLevels(made) ?? [];
    const [across, up] = made.cells;
    expect([levels[Math.round(up / 4) * across + across / 2], levels[Math.round(up / 2) * across + 20]]).toEqual([
      0, 15,
    ]);
    await press('Nach links drehen');
    expect((await floor()).size).toEqual([1000, 800]);
  });

  it('is a sheet of paper at true size on request', async () => {
    const { mounted, floor } = opened();
    await mounted.get('[data-testid="floor-size"]').setValue('A4');
    await nextTick();
    expect((await floor()).size).toEqual([297, 210]);
  });

  it('keeps the threshold that was set by hand', async () => {
    const { mounted, middle } = opened();
    const [, threshold] = mounted.findAll('input[type="range"]');
    await threshold?.setValue('5');
    await press('Graustufen');
    await press('Linie oder Boden');
    expect((mounted.findAll('input[type="range"]')[1]?.element as HTMLInputElement).value).toBe('5');
    expect((await middle())[125]).toBe(0); // black is still darker
  });
});
