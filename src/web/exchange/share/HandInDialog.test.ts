// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import type { SaidRemark } from '#check/hand-in/hand-in';
import { handInOf } from '#check/hand-in/read-hand-in';
import type { WorldResult } from '#check/result';
import { sceneWith, targetAt } from '#check/testing/tasks';
import { projectOfLink } from '#project/link/link';

import { downloads } from '../../app/testing/downloads';
import { byId, isThere, tap, write } from '../../app/testing/find';
import { mountOn } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { readyScene } from '../../session/work/catalogue/ready-courses';
import type { TaskLocks } from '../../session/work/model/task-locks';
import HandInDialog from './HandInDialog.vue';

afterEach(() => {
  vi.restoreAllMocks();
  Reflect.deleteProperty(navigator, 'share');
});

const passed: WorldResult = {
  ...{ id: 'visible', hidden: false, passed: true, reason: null, atMs: 14200, touches: 0 },
  ...{ held: ['goals'], missed: {}, hash: 'abc', trail: [], trailMs: [] },
};

/** The window on a program in a course with a target; what its run comes to is this. */
async function handIn(run: WorldResult | null = passed, noticed: readonly SaidRemark[] = []) {
  const page = createPage();
  page.settings.change({ language: 'de' });
  const files = [{ name: 'main.py', text: 'print(1)\n' }];
  page.work.openProject({ files, scene: sceneWith([targetAt(700, 450)]), course: null }, null);
  page.work.locks.task.value = { noticed: () => noticed } as TaskLocks;
  await nextTick();
  page.task.handIn.open();
  const copied: string[] = [];
  vi.spyOn(navigator.clipboard, 'writeText').mockImplementation((text) => Promise.resolve(void copied.push(text)));
  const prover = vi.fn(() => Promise.resolve(run));
  mountOn(page, HandInDialog, { prover });
  await vi.waitFor(() => expect(byId('hand-in-state').textContent).not.toContain('läuft'));
  /** The hand-in in the link that is copied with this name. */
  const inLink = async (name = 'Ada') => {
    await write(byId('hand-in-name'), name);
    await tap('hand-in-copy');
    await vi.waitFor(() => expect(copied).not.toEqual([]));
    const read = projectOfLink(copied.at(-1)!.replace(/^.*#/, '#'), readyScene);
    if ('problem' in read) throw new Error(read.problem.message);
    const content = handInOf(read.project);
    return 'handIn' in content ? content.handIn : null;
  };
  return { ...page, prover, inLink, copied };
}

describe('handing in', () => {
  it('is a link with the name that was typed, the verdict and the fingerprint of its run', async () => {
    const { prover, inLink, task } = await handIn();
    expect(byId('hand-in-state').textContent).toContain('bestanden nach 14.2 s');
    expect(task.handIn.isDone.value).toBe(false);
    const found = await inLink(' Ada ');
    expect(found?.said).toEqual({ task: '', alias: 'Ada', verdict: 'passed', tries: 0, hash: 'abc', remarks: [] });
    expect(found?.project.files).toEqual([{ name: 'main.py', text: 'print(1)\n' }]);
    expect(prover).toHaveBeenCalledOnce();
    await vi.waitFor(() => expect(byId('hand-in-said').textContent).toContain('kopiert'));
    expect(task.handIn.isDone.value).toBe(true);
  });

  it('begins at the name, and lets nothing go without one: the field says why', async () => {
    const { copied, task } = await handIn();
    await vi.waitFor(() => expect(document.activeElement).toBe(byId('hand-in-name')));
    const saved = downloads();
    for (const way of ['hand-in-copy', 'hand-in-file']) {
      await write(byId('hand-in-name'), ' ');
      byId(way).focus();
      await tap(way);
      expect(byId('hand-in-need').textContent.trim()).toBe('Schreib zuerst deinen Namen hin.');
      expect(byId('hand-in-name').getAttribute('aria-invalid')).toBe('true');
      expect(document.activeElement).toBe(byId('hand-in-name'));
    }
    expect([copied, saved, isThere('hand-in-qr'), task.handIn.isDone.value]).toEqual([[], [], false, false]);
    await write(byId('hand-in-name'), 'A');
    expect([byId('hand-in-need').textContent.trim(), isThere('hand-in-qr')]).toEqual(['', true]);
  });

  it('is a file with the same, named after the pupil', async () => {
    const { task } = await handIn();
    const saved = downloads();
    await write(byId('hand-in-name'), 'Ada');
    await tap('hand-in-file');
    expect(saved).toHaveLength(1);
    expect(saved[0]?.name).toContain('Ada');
    expect(task.handIn.isDone.value).toBe(true);
  });

  it('goes through the system where that can share, and is not done if they think better of it', async () => {
    const given: ShareData[] = [];
    let isCancelled = true;
    const share = (data: ShareData) =>
      isCancelled ? Promise.reject(new Error('AbortError')) : Promise.resolve(void given.push(data));
    Object.defineProperty(navigator, 'share', { value: share, configurable: true });
    const { task } = await handIn();
    await write(byId('hand-in-name'), 'Ada');
    await tap('hand-in-share');
    expect(task.handIn.isDone.value).toBe(false);
    isCancelled = false;
    await tap('hand-in-share');
    await vi.waitFor(() => expect(task.handIn.isDone.value).toBe(true));
    expect(given[0]).toMatchObject({ title: 'Ada', url: expect.stringContaining('#') });
  });

  it('shows the link to copy by hand where the browser forbids copying', async () => {
    await handIn();
    vi.spyOn(navigator.clipboard, 'writeText').mockRejectedValue(new Error('denied'));
    await write(byId('hand-in-name'), 'Ada');
    await tap('hand-in-copy');
    await vi.waitFor(() => expect(isThere('hand-in-link')).toBe(true));
  });

  it('tells what the page has noticed, and shows the pupil that it does', async () => {
    const { inLink } = await handIn(passed, ['hand', 'outside']);
    expect(byId('hand-in-told').textContent).toMatch(/Hand geholfen.*nicht aus diesem Editor/);
    expect((await inLink())?.said?.remarks).toEqual(['hand', 'outside']);
  });

  it('says why it has not passed, and can be done all the same', async () => {
    const { inLink } = await handIn({
      ...{ ...passed, passed: false, atMs: null },
      reason: { code: 'open', params: { done: 0, of: 1 } },
    });
    expect(byId('hand-in-state').textContent).toContain('Das Ziel ist nicht erreicht (0 von 1).');
    expect((await inLink())?.said?.verdict).toBe('open');
  });

  it('can be done where no worker can run it', async () => {
    const { inLink } = await handIn(null);
    expect(byId('hand-in-state').textContent).toContain('trotzdem');
    expect((await inLink())?.said).toMatchObject({ verdict: 'open', hash: '' });
  });
});
