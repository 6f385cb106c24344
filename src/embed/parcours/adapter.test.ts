import { describe, expect, it } from 'vitest';

import { projectToText } from '#project/file';
import { devicesProject, fullProject } from '#project/testing/projects';
import { defaultScene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';

import { greeted, hostAt, settled } from '../testing/host-at';
import { commandNames } from './command-schemas';
import { limits } from './limits';

describe('our own dialect', () => {
  it('says nothing before hello, and does nothing', () => {
    const { simulator, heard, ask } = hostAt();
    simulator.tell({ type: 'output', text: 'hi' });
    expect(heard).toEqual([]);
    expect(ask('reset')).toMatchObject({ ok: false, code: 'no-hello' });
    expect(simulator.calls).toEqual([]);
  });

  it('answers hello with its version, its app and everything it can do', () => {
    const answer = hostAt().ask('hello');
    expect(answer).toMatchObject({ parcours: 1, ok: true, versions: [1], app: '0.1.0', page: 'p1' });
    expect(answer?.['abilities']).toMatchObject({ commands: commandNames, robots: ['maqueen-lite'] });
  });

  it('refuses another version and names the ones it knows', () => {
    const { adapter, heard } = hostAt();
    adapter.receive({ parcours: 2, id: 'a', type: 'hello' });
    expect(heard).toEqual([
      expect.objectContaining({ parcours: 1, reply: 'a', ok: false, code: 'unknown-version', versions: [1] }),
    ]);
  });

  it('hears no more events after bye', () => {
    const { simulator, ask, events } = greeted();
    expect(ask('bye')).toMatchObject({ ok: true });
    simulator.tell({ type: 'started' });
    expect(events('started')).toEqual([]);
    expect(simulator.listenerCount).toBe(0);
  });

  it('takes no more messages once it is closed', () => {
    const { simulator, adapter, ask } = greeted();
    adapter.close();
    expect(ask('step')).toBeUndefined();
    expect([simulator.calls, simulator.listenerCount]).toEqual([[], 0]);
  });
});

describe('commands of our own dialect', () => {
  it('bring a project as text and as value, and give it back as its file', () => {
    const project = fullProject();
    const text = projectToText(project);
    for (const sent of [text, JSON.parse(text) as unknown]) {
      const { simulator, ask } = greeted();
      expect(ask('set-project', { project: sent })).toMatchObject({ ok: true });
      expect(simulator.project()).toEqual(project);
      expect(ask('get-project')?.['project']).toEqual(JSON.parse(text));
    }
  });

  it('say where a project is wrong, and change nothing', () => {
    const { simulator, ask } = greeted();
    const wrong = JSON.parse(projectToText(fullProject())) as { scene: { robot: { at: unknown } } };
    wrong.scene.robot.at = 'here';
    expect(ask('set-project', { project: wrong })).toMatchObject({
      ok: false,
      code: 'wrong-document',
      path: 'project.scene.robot.at',
    });
    expect(simulator.calls).toEqual([]);
  });

  it('bring files with main.py first, whatever the order', () => {
    const { simulator, ask } = greeted();
    const files = [{ name: 'drive.py', text: 'a = 1' }, { name: 'main.py', text: 'import drive' }]; // prettier-ignore
    expect(ask('set-files', { files })).toMatchObject({ ok: true });
    expect(simulator.project().files.map(({ name }) => name)).toEqual(['main.py', 'drive.py']);
    expect(ask('get-files')?.['files']).toEqual(simulator.project().files);
  });

  it('refuse a file that is longer than 256 KiB in UTF-8', () => {
    const { simulator, ask } = greeted();
    const files = [{ name: 'main.py', text: 'é'.repeat(200_000) }];
    expect(ask('set-files', { files })).toMatchObject({ code: 'wrong-message', path: 'files[0].text' });
    expect(simulator.calls).toEqual([]);
  });

  it('open, change and give back a course', () => {
    const { simulator, ask } = greeted();
    const scene = { ...defaultScene(), name: 'Bahn' };
    expect(ask('set-scene', { scene: serializeScene(scene) })).toMatchObject({ ok: true });
    const wall = { type: 'wall', id: 'w', from: [0, 0], to: [100, 0], thickness: 10 };
    expect(ask('edit', { edit: { type: 'add', objects: [wall] } })).toMatchObject({ ok: true });
    expect(simulator.project().scene.objects).toEqual([wall]);
    expect(ask('edit', { edit: { type: 'remove', ids: ['x'] } })).toMatchObject({ ok: false, code: 'refused' });
    expect(ask('edit', { edit: { type: 'dig' } })).toMatchObject({ code: 'wrong-document', path: 'edit.type' });
    expect(ask('get-scene')?.['scene']).toMatchObject({
      format: 'parcours-scene',
      name: 'Bahn',
      objects: [{ type: 'wall', id: 'w' }],
    });
  });

  it('choose robot, microcomputer, speed, seed and likeness, and refuse what there is not', () => {
    const { simulator, ask } = greeted();
    const robotOptions = { 'maqueen-plus-v2': { lamp: 'on' } };
    expect(ask('set-robot', { robot: 'maqueen-lite', robotOptions, device: 'microbit-v2' })).toMatchObject({
      ok: true,
    });
    expect(ask('set-robot', { robot: 'submarine' })).toMatchObject({ ok: false, code: 'refused' });
    expect(ask('speed', { speed: 'max' })).toMatchObject({ ok: true });
    expect(ask('speed', { speed: 3 })).toMatchObject({ code: 'wrong-message', path: 'speed' });
    expect(ask('seed', { seed: 12 })).toMatchObject({ ok: true });
    expect(ask('reality', { reality: 1.5 })).toMatchObject({ code: 'wrong-message', path: 'reality' });
    expect(ask('arena-senses', { on: true })).toMatchObject({ ok: true });
    expect(simulator.settings()).toMatchObject({ robot: 'maqueen-lite', robotOptions, speed: 'max', seed: 12, arenaSenses: true }); // prettier-ignore
    expect(ask('get-robot')).toMatchObject({ robot: 'maqueen-lite', device: 'microbit-v2', firmware: '' });
    expect(ask('state')).toMatchObject({ phase: 'ready', speed: 'max', seed: 12, ended: null });
  });

  it('set the page, and leave alone what they do not name', () => {
    const { simulator, ask } = greeted();
    expect(ask('settings', { language: 'it', parts: ['board', 'arena'], labels: { 'button-a': 'Knopf' } })).toMatchObject({ ok: true }); // prettier-ignore
    expect(simulator.settings()).toMatchObject({ language: 'it', theme: 'system', parts: ['board', 'arena'] });
    expect(ask('set-mode', { mode: 'build' })).toMatchObject({ ok: true });
    expect(ask('state')).toMatchObject({ mode: 'build' });
    expect(ask('set-mode', { mode: 'lookBack' })).toMatchObject({ ok: false, code: 'refused' });
    expect(ask('set-mode', { mode: 'fly' })).toMatchObject({ code: 'wrong-message', path: 'mode' });
    expect(ask('settings', { language: 'rm' })).toMatchObject({ code: 'wrong-message', path: 'language' });
    expect(ask('settings', { volume: 3 })).toMatchObject({ code: 'wrong-message', path: 'volume' });
  });

  it('reach into a run, and are refused where there is none', () => {
    const { simulator, ask } = greeted();
    expect(ask('press', { button: 'a', down: true })).toMatchObject({ ok: false, code: 'refused' });
    expect(ask('sensor', { sensor: 'lightLevel', value: 40 })).toMatchObject({ ok: true });
    expect(ask('sensor', { sensor: 'gesture', value: 'shake' })).toMatchObject({ ok: false, code: 'refused' });
    simulator.tell({ type: 'phase', phase: 'running' });
    ask('press', { button: 'a', down: true });
    ask('touch', { pad: 'pinLogo', down: false });
    ask('sensor', { sensor: 'gesture', value: 'shake' });
    ask('serial', { text: 'hi\r' });
    ask('interrupt');
    ask('radio', { text: 'go' });
    ask('radio', { bytes: [1, 2] });
    ask('place', { xMm: 100, yMm: 200, headingDeg: 90 });
    expect(simulator.calls.map((call) => call.call === 'input' && call.action)).toEqual([
      { type: 'sensor', id: 'lightLevel', value: 40 },
      { type: 'button', button: 'a', down: true },
      { type: 'touch', pad: 'pinLogo', down: false },
      { type: 'sensor', id: 'gesture', value: 'shake' },
      { type: 'serial', text: 'hi\r' },
      { type: 'interrupt' },
      { type: 'radio', text: 'go' },
      { type: 'radio', bytes: [1, 2] },
      { type: 'place', pose: { xMm: 100, yMm: 200, headingDeg: 90 } },
    ]);
    expect(ask('place-block', { block: 'b', xMm: 1, yMm: 1, headingDeg: 0 })).toMatchObject({ code: 'refused' });
  });

  it('are answered in their order, also behind one that takes its time', async () => {
    const { simulator, heard, say } = greeted();
    const ids = [say('run', { paused: true }), say('state'), say('nonsense'), say('resume'), say('state')];
    expect(heard.filter(({ reply }) => ids.includes(Number(reply)))).toEqual([]);
    await settled();
    const answers = heard.filter(({ reply }) => ids.includes(Number(reply)));
    expect(answers.map(({ reply }) => reply)).toEqual(ids);
    expect(answers.map((answer) => answer['phase'] ?? answer['ok'])).toEqual([true, 'paused', false, true, 'running']);
    expect(simulator.calls.map(({ call }) => call)).toEqual(['run', 'resume']);
  });

  it('are refused as busy when far too many wait, and go on afterwards', async () => {
    const { ask, say } = greeted();
    say('run');
    for (let times = 0; times < limits.waitingCommands; times += 1) say('state');
    expect(ask('state')).toMatchObject({ ok: false, code: 'busy' });
    await settled();
    expect(ask('state')).toMatchObject({ ok: true });
  });

  it('are done and not answered without an id', () => {
    const { simulator, adapter, heard } = greeted();
    const before = heard.length;
    adapter.receive({ parcours: 1, type: 'seed', seed: 5 });
    expect(simulator.settings().seed).toBe(5);
    expect(heard.slice(before).filter((message) => 'reply' in message)).toEqual([]);
  });

  it.each([
    ['a message that holds itself', () => { const own: { self?: unknown } = {}; own.self = own; return { project: own }; }, 'too-large'], // prettier-ignore
    ['lists of lists of lists that are all the same', () => { let list: unknown = []; for (let level = 0; level < 30; level += 1) list = [list, list]; return { project: { list } }; }, 'too-large'], // prettier-ignore
    ['a list as long as can be', () => ({ edit: new Array<number>(4_000_000_000) }), 'too-large'],
    ['a list whose names hold what is far too large', () => ({ edit: Object.assign([], { objects: 'x'.repeat(limits.documentCharacters + 1) }) }), 'too-large'], // prettier-ignore
    ['a buffer', () => ({ project: new Uint8Array(5_000_000) }), 'wrong-message'],
    ['a map', () => ({ project: new Map([['a', 1]]) }), 'wrong-message'],
    ['a date', () => ({ text: new Date(0) }), 'wrong-message'],
  ])('refuse %s', (_, fields, code) => {
    const { simulator, ask } = greeted();
    const type = 'edit' in fields() ? 'edit' : 'text' in fields() ? 'serial' : 'set-project';
    expect(ask(type, fields())).toMatchObject({ ok: false, code });
    expect(simulator.calls).toEqual([]);
  });

  it('cannot reach into the prototype of anything', () => {
    const { simulator, ask, adapter } = greeted();
    const hostile = (text: string): object => JSON.parse(text) as object;
    adapter.receive(hostile('{"parcours":1,"id":9,"type":"seed","seed":7,"__proto__":{"polluted":true}}'));
    ask('set-robot', hostile('{"robotOptions":{"__proto__":{"polluted":"yes"},"constructor":{"prototype":"x"}}}'));
    ask('settings', hostile('{"labels":{"__proto__":"x","button-a":"A"}}'));
    expect(({} as { polluted?: unknown }).polluted).toBeUndefined();
    expect(Object.keys(simulator.settings().robotOptions)).toEqual([]);
  });

  it('are ignored if reading them throws', () => {
    const { adapter, heard } = greeted();
    const before = heard.length;
    adapter.receive({ parcours: 1, id: 7, get type() { throw new Error('no'); } }); // prettier-ignore
    adapter.receive(new Proxy({}, { get: () => { throw new Error('no'); } })); // prettier-ignore
    expect(heard.length).toBe(before);
  });
});

describe('commands to one of several microcomputers', () => {
  const device = 'Fernbedienung';

  it('reach the one that they name, and the first without a name', () => {
    const { simulator, ask } = greeted({ project: devicesProject(), phase: 'running' });
    expect(ask('press', { button: 'a', down: true, device })).toMatchObject({ ok: true });
    expect(ask('press', { button: 'a', down: false })).toMatchObject({ ok: true });
    expect(ask('radio', { text: 'hi', device })).toMatchObject({ ok: true });
    expect(simulator.calls).toEqual([
      { call: 'input', action: { type: 'button', button: 'a', down: true }, device },
      { call: 'input', action: { type: 'button', button: 'a', down: false } },
      { call: 'input', action: { type: 'radio', text: 'hi' }, device },
    ]);
  });

  it('give and take the files of each', () => {
    const { ask } = greeted({ project: devicesProject() });
    expect(ask('state')?.['devices']).toEqual(['Roboter', 'Fernbedienung', 'Ärzt 2']);
    const files = [{ name: 'main.py', text: 'print(2)' }];
    expect(ask('set-files', { files, device })).toMatchObject({ ok: true });
    expect(ask('get-files', { device })?.['files']).toEqual(files);
    expect(ask('get-files')?.['files']).toEqual(devicesProject().files);
  });

  it('are refused for one that is not there, with the names that are', () => {
    const { ask } = greeted({ project: devicesProject(), phase: 'running' });
    const message = 'There is no device "Nobody". Known are "Roboter", "Fernbedienung", "Ärzt 2".';
    for (const [command, fields] of [
      ['press', { button: 'a', down: true }],
      ['get-files', {}],
      ['set-files', { files: [{ name: 'main.py', text: '' }] }],
    ] as const)
      expect(ask(command, { ...fields, device: 'Nobody' })).toMatchObject({ ok: false, code: 'refused', message });
  });
});
