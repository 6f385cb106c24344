// @vitest-environment happy-dom
import { nextTick } from 'vue';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import type { FurtherDevice } from '#project/project';
import type { Variables } from '#vm/debug/variables';
import { createPage, type TestPage } from '../../app/testing/page';
import { pictureOf, show, startRun } from '../../app/testing/run';
import type { Debug } from './debug';
import { isChanged } from '../../session/work/is-changed';

const needed = async (page: TestPage): Promise<Debug> => {
  page.slot.need();
  await vi.dynamicImportSettled();
  if (page.slot.debug.value === null) throw new Error('The debugger has not come.');
  return page.slot.debug.value;
};
const withN = (text: string): Variables => ({
  stack: [{ function: '<module>', file: 'main.py', line: 3, locals: [] }],
  globals: [{ name: 'n', value: { type: 'int', text } }],
});
const remote: FurtherDevice = {
  name: 'Remote',
  device: 'auto',
  firmware: '',
  robot: 'none',
  robotOptions: {},
  files: [{ name: 'main.py', text: '' }],
  sameAs: '',
};
const sentOf = (page: TestPage, type: string): unknown[] => page.sent.filter((message) => message.type === type);

/** A break point has stopped the run. */
async function holds(page: TestPage, timeUs: number, variables: Variables, device = 0): Promise<void> {
  await show(page, { timeUs, position: { file: 'main.py', line: 3, depth: 0 } });
  page.say({ type: 'held', device, timeUs });
  await nextTick();
  page.say({ type: 'variables', device, timeUs, variables });
  await nextTick();
}

beforeEach(() => sessionStorage.clear());

describe('the debugger', () => {
  it('is not there before somebody needs it', async () => {
    const page = createPage();
    await startRun(page);
    await vi.dynamicImportSettled();
    expect(page.slot.debug.value).toBeNull();
    expect(sentOf(page, 'break-points')).toEqual([]);
  });

  it('comes by itself when the program stands, and where break points are left from before', async () => {
    const page = createPage();
    await startRun(page);
    page.run.pause();
    await nextTick();
    await vi.dynamicImportSettled();
    expect(page.slot.debug.value).not.toBeNull();
    sessionStorage.setItem('parcours.break-points', '{"1/main.py":[2]}');
    const later = createPage();
    await vi.dynamicImportSettled();
    expect(later.slot.debug.value?.points.of('1/main.py')).toEqual([2]);
  });

  it('tells the run where to stop, once as long as that stays', async () => {
    const page = createPage();
    const debug = await needed(page);
    await startRun(page);
    debug.points.toggle('1/main.py', 2);
    await nextTick();
    page.work.setText('main.py', `${page.work.open.value.text}\n# more\n`); // its line stays
    await nextTick();
    expect(sentOf(page, 'break-points')).toEqual([{ type: 'break-points', points: [[{ file: 'main.py', line: 2 }]] }]);
  });

  it('shows the line and the variables at a stop, and what has changed since the one before', async () => {
    const page = createPage();
    const debug = await needed(page);
    await startRun(page);
    await holds(page, 1000, withN('1'));
    expect(page.slot.isStanding.value).toBe(true);
    expect(page.slot.showsVariables.value).toBe(true);
    expect(debug.place.value).toEqual({ file: 'main.py', line: 3 });
    expect(debug.found.value?.before.size).toBe(0);
    expect([debug.valueOf('n')?.text, debug.valueOf('m')]).toEqual(['1', null]);
    page.run.resume();
    await nextTick();
    expect([debug.place.value, debug.found.value]).toEqual([null, null]);
    await holds(page, 2000, withN('2'));
    expect([...(debug.found.value?.before ?? [])]).toEqual([['global n', '1']]);
  });

  it('follows its line through what is written since, and tells what ran where the line is gone', async () => {
    const page = createPage();
    const debug = await needed(page);
    page.work.setText('main.py', 'for i in range(9):\n    x = i\n    print(i)\n');
    debug.points.toggle('1/main.py', 3);
    await nextTick();
    await startRun(page);
    await holds(page, 1000, withN('1'));
    expect(debug.here.value).toEqual({ file: 'main.py', line: 3, ran: null });
    page.work.setText('main.py', '# a\n# b\nfor i in range(9):\n    x = i\n    print(i)\n');
    debug.points.set('1/main.py', [5]); // as the editor moves it
    await nextTick();
    expect(debug.here.value).toEqual({ file: 'main.py', line: 5, ran: 'print(i)' });
    expect(debug.place.value?.line).toBe(3);
    expect(sentOf(page, 'break-points').at(-1)).toEqual({
      type: 'break-points',
      points: [[{ file: 'main.py', line: 3 }]],
    });
    page.work.setText('main.py', 'for i in range(9):\n    x = i\n    print("new", i)\n');
    expect(debug.here.value).toEqual({ file: 'main.py', line: null, ran: 'print(i)' });
    expect(isChanged(page)).toBe(true);
    debug.points.set('1/main.py', [3]);
    await page.run.reset();
    await startRun(page);
    await nextTick();
    expect(sentOf(page, 'break-points').at(-1)).toEqual({
      type: 'break-points',
      points: [[{ file: 'main.py', line: 3 }]],
    });
    expect(isChanged(page)).toBe(false);
  });

  it('leaves the board to who has gone back to it, until the next run', async () => {
    const page = createPage();
    await needed(page);
    await startRun(page);
    await holds(page, 1000, withN('1'));
    page.slot.showsVariables.value = false;
    page.run.resume();
    await holds(page, 2000, withN('2'));
    expect(page.slot.showsVariables.value).toBe(false);
  });

  it('shows the device whose line it was', async () => {
    const page = createPage();
    await needed(page);
    page.work.addDevice(remote, 'Robot');
    page.work.showDevice(0);
    await startRun(page);
    await holds(page, 1000, withN('1'), 1);
    expect(page.work.place.value).toBe(1);
    expect(sentOf(page, 'inspect').at(-1)).toEqual({ type: 'inspect', device: 1 });
  });

  it('makes a step with the device that is shown', async () => {
    const page = createPage();
    const debug = await needed(page);
    await startRun(page);
    await holds(page, 1000, withN('1'));
    debug.step('over');
    expect(sentOf(page, 'step-line')).toEqual([{ type: 'step-line', step: 'over', device: 0 }]);
    expect(page.slot.isStanding.value).toBe(false);
  });

  it('steps on live from the last moment of the past, which is the present', async () => {
    const page = createPage();
    const debug = await needed(page);
    await startRun(page);
    await holds(page, 1000, withN('1'));
    page.run.look.back();
    await nextTick();
    expect(page.slot.isStanding.value).toBe(false);
    debug.step('over');
    await nextTick();
    expect(page.run.past.value).toBeNull();
    expect(sentOf(page, 'step-line')).toEqual([{ type: 'step-line', step: 'over', device: 0 }]);
  });

  it('goes up to the line where the cursor is, as the program that runs has it', async () => {
    const page = createPage();
    const debug = await needed(page);
    page.work.setText('main.py', 'a = 1\nb = 2\nc = 3\n');
    await startRun(page);
    await holds(page, 1000, withN('1'));
    page.work.setText('main.py', 'a = 1\nnew = 0\nb = 2\nc = 3\nlast = 4');
    debug.step({ file: 'main.py', line: 5 }); // nothing that runs is below it
    for (const line of [4, 2]) {
      debug.step({ file: 'main.py', line });
      await holds(page, 1000, withN('1'));
    }
    expect(sentOf(page, 'step-line')).toMatchObject([{ step: { line: 3 } }, { step: { line: 2 } }]);
  });

  it('makes the step in the present, too, where the return alone would move nothing', async () => {
    const page = createPage();
    const debug = await needed(page);
    await startRun(page);
    const position = { file: 'main.py', line: 9, depth: 0 };
    await show(page, { timeUs: 2000, position });
    page.run.pause();
    page.run.look.back();
    page.run.look.at(1000, pictureOf({ timeUs: 1000, position }));
    vi.spyOn(debug.past, 'step').mockResolvedValue(false);
    debug.step('over');
    await expect.poll(() => sentOf(page, 'step-line')).toHaveLength(1);
    expect(page.run.past.value).toBeNull();
  });

  it('lets the program go on from the past, too', async () => {
    const page = createPage();
    const debug = await needed(page);
    await startRun(page);
    await holds(page, 1000, withN('1'));
    page.run.look.back();
    debug.goOn();
    expect([page.run.past.value, page.run.phase.value]).toEqual([null, 'running']);
  });

  it('forgets the break points with the work that they belong to', async () => {
    const page = createPage();
    const debug = await needed(page);
    debug.points.toggle('1/main.py', 2);
    page.work.openings.value += 1;
    await nextTick();
    expect(debug.points.lines.value).toEqual({});
  });
});
