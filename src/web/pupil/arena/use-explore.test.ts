// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';

import type { Vec } from '#core/geometry';
import { maqueenLite } from '#robots/maqueen-lite/type';
import type { SceneObject } from '#scene/scene';

import { editingPage, samples } from '../../app/testing/editing';
import '../../app/testing/mount-on';
import { show, startRun } from '../../app/testing/run';
import { robotOf } from '../narration/testing/drive';
import { useArenaRun } from './use-arena-run';
import { useExplore } from './use-explore';

/** The arena's keyboard over a course with a checkpoint and a block; the robot starts in the middle. */
async function arena(objects: readonly SceneObject[] = [samples.checkpoint, samples.block]) {
  const page = await editingPage(objects);
  const shown: Vec[] = [];
  let crosshair: Vec | null = null;
  const { shownScene } = useArenaRun(page);
  const { told, keydown } = useExplore(
    { ...page, scene: () => shownScene.value, robot: () => maqueenLite, crosshair: () => crosshair },
    (at) => shown.push(at),
  );
  /** Presses a key and returns the text that the arena announces. */
  const press = async (key: string, more: KeyboardEventInit = {}): Promise<string> => {
    const event = new KeyboardEvent('keydown', { key, cancelable: true, ...more });
    keydown(event);
    await flushPromises();
    await import('../narration/explore-now');
    await flushPromises();
    return told.value.words;
  };
  return { ...page, press, told, shown, draw: (at: Vec) => (crosshair = at) };
}

describe('the keys that explore the course', () => {
  it('N walks through it, Shift+N back, and each thing is shown where it is', async () => {
    const { press, shown } = await arena();
    expect(await press('n')).toBe('Der Roboter ist bei x 60, y 45 cm, Richtung 0 Grad. Im Parcours liegen 2 Dinge.');
    expect(await press('n')).toBe('Kontrollpunkt 1, 10 mal 10 cm: 40 cm weiter hinten, 15 cm rechts.');
    expect(await press('n')).toBe('Block 1, 5 mal 5 cm: 20 cm weiter hinten, 25 cm rechts.');
    expect(await press('N', { shiftKey: true })).toContain('Kontrollpunkt 1');
    expect(shown.slice(1)).toEqual([{ x: 200, y: 300 }, { x: 400, y: 200 }, { x: 200, y: 300 }]); // prettier-ignore
  });

  it('O tells what is around the robot, or around the crosshair while one draws by keyboard', async () => {
    const { press, draw } = await arena();
    expect(await press('o')).toContain('Vorn Rand der Arena, 54 cm.');
    draw({ x: 400, y: 400 });
    expect(await press('o')).toContain('Fadenkreuz bei x 40, y 40 cm.');
  });

  it('the same words again are something new', async () => {
    const { press, told } = await arena();
    await press('o');
    const { count } = told.value;
    await press('o');
    expect(told.value.count).toBe(count + 1);
  });

  it('are told from where the robot is in the run, and of blocks where the hand has put them', async () => {
    const page = await arena();
    page.hand.blocks.value = { block: { xMm: 700, yMm: 450, headingDeg: 30 } };
    await page.press('N', { shiftKey: true });
    expect(page.told.value.words).toBe('Block 1, 5 mal 5 cm: 10 cm weiter vorn.');
    await startRun(page);
    await show(page, { robot: robotOf({ xMm: 400, yMm: 450 }), blocks: { block: { xMm: 400, yMm: 650, headingRad: 0 } } }); // prettier-ignore
    await page.press('n');
    expect(page.told.value.words).toContain('Der Roboter ist bei x 40, y 45 cm');
    await page.press('N', { shiftKey: true });
    expect(page.told.value.words).toBe('Block 1, 5 mal 5 cm: 20 cm links.');
  });

  it('tell of a tag at a block where the hand has put that', async () => {
    const tag: SceneObject = { type: 'tag', id: 'tag', at: [375, 200], number: 7, side: 60, angle: 180 };
    const page = await arena([samples.block, tag]);
    page.hand.blocks.value = { block: { xMm: 700, yMm: 450, headingDeg: 0 } };
    await page.press('N', { shiftKey: true });
    expect(page.shown.at(-1)).toEqual({ x: 675, y: 450 });
  });

  it('are left to the browser with Ctrl or Alt', async () => {
    const { press } = await arena();
    expect(await press('n', { ctrlKey: true })).toBe('');
    expect(await press('o', { altKey: true })).toBe('');
  });
});
