// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { defaultScene } from '#scene/scene';

import { noLocks } from '#check/task/task';
import { createPage } from '../../app/testing/page';
import { show, startRun } from '../../app/testing/run';
import { appSimulator } from './app-simulator';

const main = (text: string) => [{ name: 'main.py', text }];

/** A page with a program of the pupil's own, who has chosen the robot Maqueen Lite. */
function page() {
  const parts = createPage();
  const { work, settings } = parts;
  work.openProject({ files: main('mine'), scene: { ...defaultScene(), name: 'Mine' }, course: null }, null);
  settings.change({ robot: 'maqueen-lite', seed: 7 });
  return { work, settings, simulator: appSimulator(parts) };
}

describe('what a host does to the page', () => {
  beforeEach(() => vi.stubGlobal('navigator', { languages: ['de'] }));
  afterEach(() => vi.unstubAllGlobals());

  it('puts the pupil’s work aside with the robot that the pupil had chosen, not with the host’s', () => {
    const { work, settings, simulator } = page();
    expect(simulator.change({ robot: 'none', seed: 3 })).toBeNull();
    expect(simulator.setFiles(main('theirs'))).toBeNull();
    const [kept] = work.work.value.previous;
    expect(kept?.project.files).toEqual(main('mine'));
    expect(kept?.project.settings).toMatchObject({ robot: 'maqueen-lite', seed: 7 });
    expect(settings.current.value).toMatchObject({ robot: 'none', seed: 3 });
    expect(settings.own.value).toMatchObject({ robot: 'maqueen-lite', seed: 7 });
  });

  it('includes what the pupil has made of the host’s work with the hardware of that', () => {
    const { work, simulator } = page();
    simulator.setFiles(main('theirs'));
    simulator.change({ robot: 'none' });
    work.setText('main.py', 'theirs, changed');
    simulator.setFiles(main('the next'));
    const [kept] = work.work.value.previous;
    expect(kept?.project).toMatchObject({ files: main('theirs, changed'), settings: { robot: 'none' } });
  });

  it('includes the pupil’s own work that came back with what the pupil has chosen', () => {
    const { work, simulator } = page();
    simulator.setFiles(main('theirs'));
    simulator.change({ robot: 'none', seed: 3 });
    work.isBrought = false; // the pupil brought earlier work back
    work.setText('main.py', 'mine again');
    simulator.setFiles(main('the next'));
    expect(work.work.value.previous[0]?.project).toMatchObject({
      files: main('mine again'),
      settings: { robot: 'maqueen-lite', seed: 7 },
    });
  });

  it('takes no more files than a project has', () => {
    const { work, simulator } = page();
    const many = Array.from({ length: 21 }, (_, place) => ({ name: place === 0 ? 'main.py' : `a${place}.py`, text: '' })); // prettier-ignore
    expect(simulator.setFiles(many)).toContain('the limit is 20');
    expect(work.files.value).toEqual(main('mine'));
  });

  it('replaces the files of the microcomputer that it names, and hears of them', () => {
    const { work, simulator } = page();
    const remote = { name: 'remote', device: 'auto', firmware: '', robot: 'none', robotOptions: {}, files: main('r'), sameAs: '' }; // prettier-ignore
    work.addDevice(remote, 'robot');
    const told: unknown[] = [];
    simulator.listen((event) => {
      if (event.type === 'files') told.push([event.device, event.files]);
    });
    expect(simulator.setFiles(main('theirs'), 'remote')).toBeNull();
    expect(simulator.project().devices?.others[0]?.files).toEqual(main('theirs'));
    expect(simulator.project().files).toEqual(main('mine'));
    expect(told).toEqual([['remote', main('theirs')]]);
    expect(simulator.setFiles(main('theirs'), 'nobody')).toMatch(/no device "nobody"/);
  });

  it('enters the modes that are offered, and says why another is not', async () => {
    const parts = createPage();
    const simulator = appSimulator(parts);
    expect(simulator.enterMode('lookBack')).toBe('This needs a run that has been.');
    expect([simulator.enterMode('build'), simulator.mode()]).toEqual([null, 'build']);
    await startRun(parts);
    await show(parts, { timeUs: 1_000_000 });
    expect([simulator.enterMode('lookBack'), simulator.mode(), simulator.phase()]).toEqual([null, 'lookBack', 'paused']); // prettier-ignore
    parts.work.locks.task.value = { locks: { ...noLocks, course: true } } as never;
    expect(simulator.enterMode('build')).toBe('The task that is open keeps this as it is.');
    expect([simulator.mode(), simulator.enterMode('drive'), simulator.mode()]).toEqual(['lookBack', null, 'drive']);
    parts.work.locks.task.value = null;
    simulator.change({ parts: ['code', 'arena'] });
    expect(simulator.enterMode('build')).toBe('The page shows no tools: "tools" is not among its parts.');
  });
});
