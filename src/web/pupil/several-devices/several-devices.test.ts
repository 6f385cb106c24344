// @vitest-environment happy-dom
import { nextTick } from 'vue';
import { describe, expect, it, vi } from 'vitest';

import { robotColors } from '#scene/scene';

import { byId, idsShown, tap } from '../../app/testing/find';
import { mountOn, named, setWindow, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { pictureOf, startRun } from '../../app/testing/run';
import AppDialog from '../../app/AppDialog.vue';
import { useTurnToRun } from '../../app/use-turn-to-run';
import DeviceList from '../device/DeviceList.vue';
import DevicePanel from '../device/DevicePanel.vue';
import ConsolePane from '../console/ConsolePane.vue';
import SharedConsole from '../console/SharedConsole.vue';
import { colorsOfDevices } from '../../session/work/hardware/device-colors';
import { hardwareNow } from '../../session/work/hardware/use-hardware';
import { courses } from '#catalogue/courses';
import { useCourses } from '../../session/work/use-courses';
import DeviceRow from './DeviceRow.vue';
import { addDevice, removeDevice } from './change-devices';
import { firstName, newBoard, newRobot, newTwin } from './new-device';
import { setUp } from './set-up';

const finished = { kind: 'finished', exception: null, timeUs: 1 } as const;
const program = ({ work }: TestPage): string => work.open.value.text;

/** A page whose first device has a robot, with a remote control beside it. */
function pair(): TestPage {
  const page = createPage();
  page.work.setText('main.py', 'from mbrobot import *\n');
  page.work.addDevice(newBoard(page), firstName(page));
  return page;
}

/** Opens the device's menu, which gives way to what it leads to. */
function openPanel(page: TestPage): void {
  mountOn(page, DevicePanel, { onLeave: (open: () => void) => open() });
}

describe('a second device', () => {
  it('is added from the device’s menu: asked is only whether it has a robot', async () => {
    const page = createPage();
    page.scope.run(() => setUp(page));
    openPanel(page);
    await tap('add-device');
    mountOn(page, AppDialog);
    await vi.waitFor(() => byId('add-device-board'), 20_000);
    expect(textOf(document.querySelector('h2'))).toBe('Weiteres Gerät');
    await tap('add-device-board');
    expect(page.work.devices.value).toEqual(['Roboter', 'Fernbedienung']);
    expect(page.dialogs.current.value).toBeNull();
    expect([page.work.place.value, program(page)]).toEqual([1, 'from microbit import *\nimport radio\n\nradio.on()\n']);
  });

  it('has a program of its own, or the same as another', async () => {
    const page = pair();
    page.work.setText('main.py', 'remote');
    page.work.addDevice(newTwin(page), firstName(page));
    expect([page.work.devices.value[2], program(page)]).toEqual(['Fernbedienung 2', 'remote']);
    page.work.setText('main.py', 'both');
    page.work.showDevice(1);
    expect(program(page)).toBe('both');
    page.work.showDevice(0);
    expect(program(page)).toBe('from mbrobot import *\n');
    page.work.showDevice(2);
    openPanel(page);
    await tap(named('Eigenes Programm', '[role="menuitem"]'));
    page.work.setText('main.py', 'own');
    page.work.showDevice(1);
    expect(program(page)).toBe('both');
  });

  it('is taken away with what was written put aside, and its numbers follow', async () => {
    const page = pair();
    page.work.setText('main.py', 'written');
    page.work.addDevice(newRobot(page), firstName(page));
    page.work.showDevice(1);
    openPanel(page);
    await tap('device-remove');
    expect(page.work.devices.value).toEqual(['Roboter', 'Roboter 2']);
    const kept = page.work.work.value.previous[0]?.project.devices?.others[0];
    expect([kept?.name, kept?.files[0]?.text]).toEqual(['Fernbedienung', 'written']);
    page.work.showDevice(1);
    page.work.removeDevice(1, 'x');
    expect([page.work.hasSeveral.value, page.work.work.value.project.devices]).toEqual([false, undefined]);
  });

  it('comes back from the message in its place, with what was written, and with those that run its program', () => {
    const page = pair();
    page.work.setText('main.py', 'written');
    page.work.addDevice(newTwin(page), firstName(page));
    const before = page.work.work.value.project;
    page.work.showDevice(1);
    removeDevice(page);
    expect(page.notices.current.value?.values).toEqual({ text: '«Fernbedienung» ist entfernt.' });
    page.notices.current.value?.action?.run();
    expect([page.work.work.value.project, page.work.place.value]).toEqual([before, 1]);
  });

  it('goes again from the message when it was added, but what was written on it meanwhile is put aside', async () => {
    const page = createPage();
    addDevice(page, newBoard(page));
    expect(page.notices.current.value?.values).toEqual({ text: '«Fernbedienung» ist dazugekommen.' });
    page.notices.current.value?.action?.run();
    expect([page.work.hasSeveral.value, page.work.work.value.previous, page.notices.current.value]).toEqual([
      ...[false, [], null],
    ]);
    await startRun(page);
    addDevice(page, newBoard(page));
    expect(page.notices.current.value?.values).toEqual({
      text: '«Fernbedienung» ist dazugekommen. Der Lauf ist zu Ende.',
    });
    page.work.setText('main.py', 'written');
    page.notices.current.value?.action?.run();
    expect(page.work.work.value.previous[0]?.project.devices?.others[0]?.files[0]?.text).toBe('written');
  });

  it('has the name and the colour that the course gives its robot, the first one, too', () => {
    const page = createPage();
    const start = { type: 'start', id: 'start-1', at: [300, 300], heading: 0, robot: null, options: {} } as const;
    page.work.edit({ type: 'add', objects: [{ ...start, name: 'Bo', color: 'pink' }] });
    page.work.edit({ type: 'robot', robot: { name: 'Ada', color: 'teal' } });
    page.work.addDevice(newRobot(page), firstName(page));
    expect(page.work.devices.value).toEqual(['Ada', 'Bo']);
    expect(colorsOfDevices(page).map((color) => robotColors[color])).toEqual(['teal', 'pink']);
  });

  it('is put aside with the rest when a course is opened, also beside a program that nobody has changed', () => {
    const page = createPage();
    page.work.addDevice(newBoard(page), firstName(page));
    page.work.setText('main.py', 'written');
    const { openWhole } = useCourses(page);
    const [course] = courses;
    if (course === undefined) throw new Error('There should be courses.');
    openWhole(course);
    expect(page.work.hasSeveral.value).toBe(false);
    const kept = page.work.work.value.previous[0];
    expect(kept?.project.devices?.others[0]?.files[0]?.text).toBe('written');
    if (kept !== undefined) useCourses(page).restore(kept);
    page.work.showDevice(1);
    expect(program(page)).toBe('written');
  });

  it('gets another name, which no other device has', async () => {
    const page = pair();
    openPanel(page);
    mountOn(page, AppDialog);
    await tap('device-rename');
    const field = document.getElementById('device-name') as HTMLInputElement;
    const type = async (name: string): Promise<void> => {
      field.value = name;
      field.dispatchEvent(new Event('input'));
      await nextTick();
    };
    await type('Roboter');
    expect(textOf(document.getElementById('device-name-problem'))).toBe('Ein anderes Gerät heisst schon so.');
    field.form?.requestSubmit();
    expect(page.work.devices.value[1]).toBe('Fernbedienung');
    await type('Sender');
    field.form?.requestSubmit();
    expect(page.work.devices.value[1]).toBe('Sender');
  });

  it('can be the eighth, and no further one is offered', () => {
    const page = pair();
    while (page.work.devices.value.length < 8) page.work.addDevice(newRobot(page), firstName(page));
    expect(new Set(page.work.devices.value).size).toBe(8);
    mountOn(page, DeviceRow);
    openPanel(page);
    expect(idsShown('add-device')).toEqual([]);
  });
});

describe('the row of devices', () => {
  it('says of each how it is, and chooses what is shown below', async () => {
    const page = pair();
    mountOn(page, DeviceRow);
    named('1Roboter, bereit');
    await startRun(page);
    const [first, second] = [pictureOf({ name: 'Roboter' }), pictureOf({ name: 'Fernbedienung' })];
    page.say({ type: 'snapshot', snapshot: { ...first, others: [second] }, trails: [[], []] });
    page.say({ type: 'program-ended', ended: finished, device: 1 });
    await nextTick();
    named('1Roboter, läuft');
    expect(named('2Fernbedienung, Programm zu Ende').getAttribute('aria-pressed')).toBe('true');
    await tap(named('1Roboter, läuft'));
    expect([page.work.place.value, page.run.shown.value?.name]).toEqual([0, 'Roboter']);
  });

  it('presses the buttons of a device that is not shown', async () => {
    const page = pair();
    page.work.showDevice(0);
    mountOn(page, DeviceRow);
    await startRun(page);
    named('Fernbedienung: Taste A').dispatchEvent(new PointerEvent('pointerdown', { button: 0, bubbles: true }));
    named('Roboter: Taste B').dispatchEvent(new PointerEvent('pointerdown', { button: 0, bubbles: true }));
    const inputs = page.sent.filter(({ type }) => type === 'input');
    expect(inputs).toEqual([
      { type: 'input', action: { type: 'button', button: 'a', down: true }, device: 'Fernbedienung' },
      { type: 'input', action: { type: 'button', button: 'b', down: true } },
    ]);
    expect(page.work.place.value).toBe(0);
  });
});

describe('a run of several devices', () => {
  it('gets each with its files and its hardware', async () => {
    const page = pair();
    await startRun(page);
    const run = page.sent.find((message) => message.type === 'run');
    expect(run?.setup.devices.map(({ name, robot, board }) => [name, robot, board])).toEqual([
      ['Roboter', 'maqueen-lite', 'microbit-v2'],
      ['Fernbedienung', 'none', 'microbit-v2'],
    ]);
    expect(run?.setup.devices[1]?.files['main.py']).toContain('radio.on()');
  });

  it('has a console for each, and one for all in which each line has its device', async () => {
    const page = pair();
    await startRun(page);
    const output = [
      { device: 1, text: 'sent\nhal', timeUs: 1_500_000 },
      { device: 0, text: 'heard\n', timeUs: 1_600_000 },
      { device: 1, text: 'f\n', timeUs: 1_700_000 },
    ];
    page.say({ type: 'console', output });
    expect(page.console.toText()).toBe('sent\nhalf\n');
    mountOn(page, SharedConsole);
    expect([...document.querySelectorAll('.line')].map(textOf)).toEqual([
      '1.52Fernbedienungsent',
      '1.61Roboterheard',
      '1.52Fernbedienunghalf',
    ]);
    await tap(document.querySelectorAll<HTMLElement>('.who')[1]!);
    expect([page.work.place.value, page.console.isTogether.value, page.console.toText()]).toEqual([
      0,
      false,
      'heard\n',
    ]);
  });

  it('lists what each sends by radio, in the order of time, with its device', async () => {
    const page = pair();
    await startRun(page);
    const sent = (device: number, timeUs: number): void => {
      const radio = [{ timeUs, group: 0, bytes: [1, 0, 1, 65 + device] }];
      page.say({ type: 'events', events: { sound: [], radio, radioDropped: 0, log: [] }, device });
    };
    sent(0, 30_000);
    sent(1, 20_000);
    expect(page.radio.entries.value.map(({ text, device }) => [text, device])).toEqual([['B', 1], ['A', 0]]); // prettier-ignore
    page.radio.send('all');
    expect(page.sent.at(-1)).toEqual({ type: 'input', action: { type: 'radio', text: 'all' } });
  });

  it('keeps what is set on a sensor with its device', async () => {
    const page = pair();
    page.sensors.set('lightLevel', 7);
    page.work.showDevice(0);
    expect(page.sensors.wishes.value).toEqual({});
    page.sensors.set('lightLevel', 200);
    await startRun(page);
    const run = page.sent.find((message) => message.type === 'run');
    const set = run?.setup.inputs?.filter(({ action }) => action.type === 'sensor');
    expect(set?.map(({ device, action }) => [device, action.type === 'sensor' && action.value])).toEqual([
      [undefined, 200],
      ['Fernbedienung', 7],
    ]);
  });

  it('ends when another device is added or taken away, but goes on while a program is written', async () => {
    const page = pair();
    await startRun(page);
    page.work.setText('main.py', 'more');
    page.work.showDevice(0);
    await nextTick();
    expect(page.run.phase.value).toBe('running');
    page.work.removeDevice(1, 'x');
    expect(page.run.phase.value).not.toBe('running');
  });

  it('explains an error in the console of its device', async () => {
    const page = pair();
    await startRun(page);
    const traceback =
      'Traceback (most recent call last):\n  File "main.py", line 2, in <module>\nZeroDivisionError: x\n';
    const exception = { type: 'ZeroDivisionError', message: 'x', traceback };
    page.say({ type: 'program-ended', ended: { kind: 'exception', exception, timeUs: 1 } as never, device: 1 });
    expect(page.jump.wrong.value).toEqual({ file: 'main.py', line: 2, device: 1 });
    expect(page.console.entries.value.some(({ kind }) => kind === 'error')).toBe(true);
    expect(page.console.isTogether.value).toBe(false);
    page.work.showDevice(0);
    expect(page.console.entries.value.some(({ kind }) => kind === 'error')).toBe(false);
    page.console.isTogether.value = true;
    mountOn(page, ConsolePane);
    page.work.showDevice(1);
    await nextTick();
    expect(page.console.isTogether.value).toBe(false);
  });
});

it('a phone turns to the arena while the remote control is shown, because another device drives', async () => {
  setWindow(390, 844);
  const page = pair();
  page.layout.tab.value = 'code';
  page.scope.run(() => useTurnToRun(page));
  await startRun(page);
  expect(page.layout.tab.value).toBe('arena');
});

it('keeps what is chosen for a device to that device alone', async () => {
  const page = pair();
  mountOn(page, DeviceList);
  byId('board-calliope-mini-3').querySelector('input')?.dispatchEvent(new Event('change'));
  byId('robot-callibot').querySelector('input')?.dispatchEvent(new Event('change'));
  await nextTick();
  const boardsNow = (): readonly unknown[] =>
    [0, 1].map((place) => [hardwareNow(page, place)?.board.id, hardwareNow(page, place)?.robot?.id]);
  expect(boardsNow()).toEqual([
    ['microbit-v2', 'maqueen-lite'],
    ['calliope-mini-3', 'callibot'],
  ]);
  expect(page.settings.current.value).toMatchObject({ device: 'auto', robot: 'auto' });
});
