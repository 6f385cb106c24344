import { describe, expect, it } from 'vitest';

import { devicesProject } from '#project/testing/projects';

import { greeted, settled } from '../testing/host-at';

const VARIABLES = {
  stack: [
    { function: 'turn', file: 'main.py', line: 3, locals: [{ name: 'n', value: { type: 'int', text: '4' } }] },
    { function: '<module>', file: 'main.py', line: 9, locals: [] },
  ],
  globals: [{ name: '__proto__', value: { type: 'str', text: "'x'" } }],
} as const;

/** The answer, once everything that was promised has arrived. */
async function asked(host: ReturnType<typeof greeted>, type: string, fields: object = {}) {
  const id = host.say(type, fields);
  await settled();
  return host.answerTo(id);
}

describe('commands about lines and time', () => {
  it('tell where the program is, in the form of the command line, whatever its variables are called', async () => {
    const host = greeted({ phase: 'paused' });
    host.simulator.where = { timeUs: 1_234_500, variables: VARIABLES };
    const { parcours: _, reply: __, ok, ...position } = (await asked(host, 'get-position'))!;
    expect(ok).toBe(true);
    expect(JSON.stringify(position)).toBe(
      '{"atMs":1234.5,"file":"main.py","line":3,"stack":[' +
        '{"function":"turn","file":"main.py","line":3,"locals":{"n":{"type":"int","text":"4"}}},' +
        '{"function":"<module>","file":"main.py","line":9,"locals":{}}],' +
        '"globals":{"__proto__":{"type":"str","text":"\'x\'"}}}',
    );
  });

  it('tell no line while none of its functions runs', async () => {
    const host = greeted({ phase: 'running' });
    host.simulator.where = { timeUs: 0, variables: { stack: [], globals: [] } };
    expect(await asked(host, 'get-position')).toMatchObject({ file: null, line: null, stack: [], globals: {} });
  });

  it('set break points, step, look and go on', async () => {
    const host = greeted({ phase: 'paused' });
    const points = [{ file: 'main.py', line: 3 }];
    expect(await asked(host, 'set-break-points', { points })).toMatchObject({ ok: true });
    expect(await asked(host, 'get-break-points')).toMatchObject({ points });
    expect(await asked(host, 'step-line', { step: 'back' })).toMatchObject({ ok: true });
    expect(await asked(host, 'run-to', { file: 'main.py', line: 5 })).toMatchObject({ ok: true });
    expect(await asked(host, 'look-at', { atMs: 1200.5 })).toMatchObject({ ok: true });
    expect(await asked(host, 'state')).toMatchObject({ looking: true });
    expect(await asked(host, 'go-on', { paused: true })).toMatchObject({ ok: true });
    expect(await asked(host, 'look-now')).toMatchObject({ ok: true });
    expect(host.simulator.calls).toEqual([
      { call: 'setBreakPoints', points },
      { call: 'stepLine', step: 'back' },
      { call: 'stepLine', step: { file: 'main.py', line: 5 } },
      { call: 'lookAt', timeUs: 1_200_500 },
      { call: 'goOn', paused: true },
      { call: 'lookNow' },
    ]);
    expect(host.events('looking')).toEqual([{ parcours: 1, type: 'looking', atMs: 1200.5 }]);
  });

  it('are refused with a sentence and the place of the mistake', async () => {
    const host = greeted();
    for (const [type, fields, path] of [
      ['step-line', { step: 'sideways' }, 'step'],
      ['step-line', {}, 'step'],
      ['run-to', { file: 'main.py' }, 'line'],
      ['run-to', { file: '', line: 1 }, 'file'],
      ['set-break-points', { points: [{ file: 'main.py', line: 0.5 }] }, 'points.0.line'],
      ['set-break-points', { points: 'all' }, 'points'],
      ['look-at', { atMs: -1 }, 'atMs'],
      ['look-at', { atMs: NaN }, 'atMs'],
      ['go-on', { paused: 1 }, 'paused'],
    ] as const)
      expect(await asked(host, type, fields), path).toMatchObject({ ok: false, code: 'wrong-message', path });
    expect(host.simulator.calls).toEqual([]);
    expect(await asked(host, 'get-position')).toMatchObject({
      code: 'refused',
      message: 'This needs a run; it is "ready".',
    });
    expect(await asked(host, 'get-position', { device: 'nobody' })).toMatchObject({
      code: 'refused',
      message: expect.stringContaining('no device "nobody"'),
    });
  });

  it('take the name of a microcomputer, and tell it', async () => {
    const project = devicesProject();
    const device = project.devices!.others[0]!.name;
    const host = greeted({ project, phase: 'paused' });
    expect(await asked(host, 'step-line', { step: 'over', device })).toMatchObject({ ok: true });
    expect(host.simulator.calls).toEqual([{ call: 'stepLine', step: 'over', device }]);
    host.simulator.tell({ type: 'held', timeUs: 7000, file: 'main.py', line: 2, device });
    expect(host.events('held')).toEqual([{ parcours: 1, type: 'held', atMs: 7, file: 'main.py', line: 2, device }]);
  });

  it('are ended by stop if they wait for a run that does not answer', async () => {
    const host = greeted({ phase: 'running' });
    host.simulator.where = null;
    const [position, stop] = [host.say('get-position'), host.say('stop')];
    await settled();
    expect(host.answerTo(position)).toMatchObject({ ok: false, code: 'refused', message: 'The run was stopped.' });
    expect(host.answerTo(stop)).toMatchObject({ ok: true });
  });
});
