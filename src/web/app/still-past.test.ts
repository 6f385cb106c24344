// @vitest-environment happy-dom
import { describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { editingPage, samples } from './testing/editing';
import { askForDevice, askForName } from '../pupil/several-devices/ask-device';
import { newBoard } from '../pupil/several-devices/new-device';
import { useDevice } from '../session/work/hardware/use-device';
import { show, startRun } from './testing/run';

/** A course with a wall that is still to be drawn, and a run that is looked back at with the pen in hand. */
async function lookingBack() {
  const page = await editingPage([samples.stroke]);
  page.editor.choose('pen');
  await startRun(page);
  await show(page, { timeUs: 1_000_000 });
  page.run.look.back();
  await nextTick();
  return page;
}
const added = { type: 'add', objects: [samples.block] } as const;

describe('while somebody looks back', () => {
  it('nothing changes the course, nothing ends the run, and it is told why', async () => {
    const page = await lookingBack();
    const before = page.scene();
    expect(page.editor.commit(added)).toBe(false);
    page.editor.undo();
    expect([page.scene(), page.run.phase.value]).toEqual([before, 'paused']);
    expect(page.run.past.value?.timeUs).toBe(1_000_000);
    await vi.dynamicImportSettled();
    expect(page.notices.current.value?.values).toEqual({ text: expect.stringContaining('Zurück zu jetzt') });
  });

  it('not even what was drawn before is taken back; it is as soon as the present is there again', async () => {
    const page = await editingPage([]);
    page.editor.commit(added);
    await startRun(page);
    await show(page, { timeUs: 1_000_000 });
    page.run.look.back();
    page.editor.undo();
    expect(page.ids()).toEqual([samples.block.id]);
    page.mode.enter('build');
    page.editor.undo();
    expect(page.ids()).toEqual([]);
  });

  it('no device is added, made another or taken away', async () => {
    const page = await lookingBack();
    page.work.addDevice(newBoard(page), 'A');
    askForDevice(page);
    askForName(page);
    const device = useDevice(page);
    device.chooseDevice('calliope-mini-3');
    device.chooseRobot('none');
    device.chooseReality(1);
    await nextTick();
    expect([page.work.devices.value.length, page.dialogs.current.value]).toEqual([1, null]);
    expect(page.settings.current.value).toMatchObject({ device: 'auto', robot: 'auto', reality: 0 });
    expect([page.run.phase.value, page.run.past.value?.timeUs]).toEqual(['paused', 1_000_000]);
    page.run.look.leave();
    page.work.addDevice(newBoard(page), 'A');
    expect(page.work.devices.value).toHaveLength(2);
  });
});
