// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { withoutSecrets } from '#check/task/write-task';
import { createRng } from '#core/rng';
import { editProblem } from '#scene/check-edit';
import { applyEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import { randomEdit } from '#scene/testing/random-scene';

import { useSelectionActs } from '../course/editor/state/use-selection-acts';
import { appSimulator } from '../exchange/host/app-simulator';
import { editingPage, samples, type EditingPage } from './testing/editing';
import { show, startRun } from './testing/run';

const EDITS = 300;
/** Every tool but the ruler, which changes nothing. */
const BUILDING = [
  ...(['select', 'points', 'rotate', 'pen', 'eraser', 'block'] as const),
  ...(['wall', 'maze', 'zone', 'label', 'start'] as const),
];

beforeAll(() => import('../pupil/locks/lock-task')); // its first coming takes a while on a busy machine
beforeEach(() => {
  sessionStorage.clear();
  localStorage.clear();
});

/** A page on which a pupil has drawn something, and may not build any more. */
const CLOSED: Readonly<Record<string, () => Promise<EditingPage>>> = {
  'in a task with a locked course': async () => {
    const page = await drawn();
    const { project } = page.work.work.value;
    const task = { version: 1, checks: [{ type: 'loop', id: 'loop' }], locks: { course: true } };
    page.work.openProject(withoutSecrets({ ...project, task }), null);
    await vi.waitFor(() => expect(page.work.locks.task.value).not.toBeNull());
    return page;
  },
  'while somebody looks back': async () => {
    const page = await drawn();
    await startRun(page);
    await show(page, { timeUs: 1_000_000 });
    page.run.look.back();
    await nextTick();
    return page;
  },
};

async function drawn(): Promise<EditingPage> {
  const page = await editingPage([samples.stroke, samples.block]);
  page.editor.commit({ type: 'remove', ids: [samples.stroke.id] });
  return page;
}

/** Edits of every kind that would change this course if they might. */
function editsOf(scene: Scene): ReturnType<typeof randomEdit>[] {
  const rng = createRng(11);
  const edits = Array.from({ length: EDITS * 3 }, () => randomEdit(rng, scene));
  return edits.filter((edit) => editProblem(scene, edit) === null && applyEdit(scene, edit) !== scene).slice(0, EDITS);
}

describe.each(Object.entries(CLOSED))('%s', (_, open) => {
  it('no edit of any kind changes the course, by the editor or by a host, who is told so', async () => {
    const page = await open();
    const before = page.scene();
    const host = appSimulator(page);
    const edits = editsOf(before);
    expect([edits.length, new Set(edits.map(({ type }) => type)).size]).toEqual([EDITS, 7]);
    for (const edit of edits) {
      expect(page.editor.commit(edit)).toBe(false);
      expect(host.edit(edit)).toMatch(/stays as it was|keeps this as it is/);
    }
    expect(page.scene()).toBe(before);
  });

  it('nothing that is done to a selection changes the course, nor do undo and redo', async () => {
    const page = await open();
    const before = page.scene();
    page.editor.select({ ids: page.ids(), robot: true });
    const acts = useSelectionActs(page);
    acts.mirror('x');
    acts.align('left');
    acts.distribute('y');
    acts.reorder('front');
    acts.turn(90);
    acts.group();
    acts.lock();
    acts.sizeAlike();
    acts.duplicate();
    acts.remove();
    page.editor.undo();
    page.editor.redo();
    expect(page.scene()).toBe(before);
  });

  it('no tool that builds can be taken', async () => {
    const page = await open();
    for (const tool of BUILDING) {
      page.editor.choose(tool);
      expect(page.editor.tool.value, tool).toBe('hand');
    }
  });
});
