// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { nothingMeasured, type Measured } from '#my-robot/my-robot';
import { idealTraits } from '#robots/traits';
import { byId, isThere, tap, write } from '../../app/testing/find';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import type { Fit } from '../../session/run/fit-client';
import { runSetup } from '../../session/work/run-setup';
import MyRobotPage from './MyRobotPage.vue';

const here = { aheadMm: 370, leftMm: 0 };
const motion = { drives: { slow: here, usual: here, fast: here }, turnDeg: 590 };
const weakRight = { ...idealTraits, motors: { difference: 0.047, charge: 0.98, sag: 0.05, friction: 0 } };

beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
afterEach(() => {
  vi.useRealTimers();
  history.replaceState(null, '', '/');
});

/** The page for a robot, with a fit that always finds the same. */
async function opened(robot = 'maqueen-lite', fails = false) {
  const page = createPage();
  page.settings.change({ language: 'de', robot });
  const asked: { robot: string; measured: Measured }[] = [];
  const fitter = (id: string, measured: Measured): Promise<Fit> => {
    asked.push({ robot: id, measured });
    const after = { ...motion, drives: { ...motion.drives, usual: measured.drives.usual ?? here } };
    return fails
      ? Promise.reject(new Error('no worker'))
      : Promise.resolve({ traits: weakRight, before: motion, after });
  };
  mountOn(page, MyRobotPage, { fitter });
  await nextTick();
  const mine = () => page.settings.current.value.myRobot;
  return { page, asked, mine };
}
const field = (within: string, index: number): HTMLInputElement => {
  const found = byId(within).querySelectorAll('input')[index];
  if (found === undefined) throw new Error(`There is no field ${String(index)} in ${within}.`);
  return found;
};
/** The typist pauses, and the fit comes. */
async function pause(): Promise<void> {
  await vi.advanceTimersByTimeAsync(500);
  await nextTick();
  await nextTick();
}

describe('measuring one’s own robot', () => {
  it('takes centimetres with comma or point, to the side that was chosen, and keeps them at once', async () => {
    const { mine } = await opened();
    await write(field('drive-usual', 0), '36,4');
    await write(field('drive-usual', 1), '2.1');
    expect(mine()?.measured.drives.usual).toEqual({ aheadMm: 364, leftMm: 21 });
    await tap(byId('drive-usual').querySelectorAll('button')[1]!);
    expect(mine()?.measured.drives.usual).toEqual({ aheadMm: 364, leftMm: -21 });
  });

  it('says what is no number or cannot be, and keeps the one before', async () => {
    const { mine } = await opened();
    await write(field('drive-slow', 0), '30');
    await write(field('drive-slow', 0), 'weit');
    expect(textOf(byId('drive-slow').querySelector('[role=alert]'))).toBe('Bitte eine Zahl.');
    await write(field('drive-slow', 0), '999');
    expect(textOf(byId('drive-slow').querySelector('[role=alert]'))).toBe('Von 0 bis 300 cm.');
    expect(mine()?.measured.drives.slow?.aheadMm).toBe(300);
  });

  it('fits once the typist pauses, and tells by how much it drove beside before and after', async () => {
    const { asked, mine } = await opened();
    await write(field('drive-usual', 0), '3');
    await write(field('drive-usual', 0), '36');
    expect(asked).toEqual([]);
    await pause();
    expect(asked.map(({ robot, measured }) => [robot, measured.drives.usual?.aheadMm])).toEqual([
      ['maqueen-lite', 360],
    ]);
    expect(textOf(byId('fit-before'))).toContain('10 mm daneben');
    expect(textOf(byId('fit-after'))).toContain('0 mm daneben');
    expect(textOf(byId('fit-traits'))).toContain('105 %');
    expect(mine()?.traits).toEqual(weakRight);
  });

  it('lets the simulated robot drive like it only when that is wished', async () => {
    const { page } = await opened();
    await write(field('drive-usual', 0), '36');
    await pause();
    expect(runSetup(page, () => []).devices[0].traits).toBeUndefined();
    await tap('my-robot-use');
    expect(runSetup(page, () => []).devices[0].traits).toEqual(weakRight);
    page.settings.change({ robot: 'maqueen-plus-v2' });
    expect(runSetup(page, () => []).devices[0].traits).toBeUndefined();
  });

  it('counts whole turns and adds the angle', async () => {
    const { mine } = await opened();
    await tap('step-turn');
    const [turns, rest] = [...document.querySelectorAll<HTMLInputElement>('.measure input')];
    await write(turns!, '1');
    await write(rest!, '224');
    expect(mine()?.measured.turnDeg).toBe(584);
    expect(textOf(byId('step-turn'))).toContain('gemessen');
  });

  it('asks for shades of grey only of a robot that sees them', async () => {
    await opened();
    expect(isThere('step-line')).toBe(false);
    const select = byId('my-robot-type') as unknown as HTMLSelectElement;
    select.value = 'maqueen-plus-v2';
    select.dispatchEvent(new Event('change'));
    await nextTick();
    await tap('step-line');
    expect(document.querySelectorAll('.measure input').length).toBe(10);
  });

  it('takes a line sensor with both numbers, and says when they are alike', async () => {
    const { mine } = await opened('maqueen-plus-v2');
    await tap('step-line');
    const [black, white] = [...document.querySelectorAll<HTMLInputElement>('.measure input')];
    await write(black!, '90');
    expect(mine()?.measured.line ?? {}).toEqual({});
    await write(white!, '90');
    expect(textOf(document.querySelector('.blind'))).toBe('L2 zeigt beide Male dasselbe: Miss noch einmal.');
    await write(white!, '210');
    expect(mine()?.measured.line).toEqual({ L2: { black: 90, floor: 210 } });
  });

  it('keeps the numbers when the calculation fails, and tries again on demand', async () => {
    const { asked, mine } = await opened('callibot', true);
    await write(field('drive-fast', 0), '26');
    await pause();
    expect(textOf(document.querySelector('.fit'))).toContain('Das Rechnen ist misslungen.');
    expect(mine()?.measured.drives.fast?.aheadMm).toBe(260);
    await tap(
      [...document.querySelectorAll<HTMLButtonElement>('.fit button')].find((it) => textOf(it) === 'Nochmals')!,
    );
    await pause();
    expect(asked.length).toBe(2);
  });

  it('forgets all on demand', async () => {
    const { mine } = await opened();
    await write(field('drive-usual', 0), '36');
    await tap(
      [...document.querySelectorAll<HTMLButtonElement>('button')].find((it) => textOf(it) === 'Messung löschen')!,
    );
    expect(mine()).toBeNull();
    expect(field('drive-usual', 0).value).toBe('');
  });

  it('opens with what was measured before, and fits it', async () => {
    const page = createPage();
    const drives = { ...nothingMeasured.drives, usual: { aheadMm: 355, leftMm: 0 } };
    const measured = { ...nothingMeasured, drives };
    page.settings.change({ myRobot: { name: 'Röbi', robot: 'callibot', used: true, measured, traits: idealTraits } });
    mountOn(page, MyRobotPage, { fitter: () => Promise.resolve({ traits: weakRight, before: motion, after: motion }) });
    await pause();
    expect((byId('my-robot-name') as HTMLInputElement).value).toBe('Röbi');
    expect((byId('my-robot-type') as unknown as HTMLSelectElement).value).toBe('callibot');
    expect(field('drive-usual', 0).value).toBe('35.5');
    expect(byId('my-robot-use').getAttribute('aria-pressed')).toBe('true');
  });
});
