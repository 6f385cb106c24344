import { describe, expect, it } from 'vitest';
import { computed, effectScope, shallowRef } from 'vue';

import { applyEdit, type SceneEdit } from '#scene/edit';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';
import type { InputAction } from '#simulation/input';

import type { RunPhase } from '#simulation/pace';
import { useLiveEdits } from './use-live-edits';
import { WorkModel } from './work-model';

const block = (id: string): SceneObject => ({ type: 'block', id, at: [100, 100], size: [50, 50], turn: 0 });
const adding = (id: string): SceneEdit => ({ type: 'add', objects: [block(id)] });

/** A course that is worked on beside a run that only notes what it is told. */
function beside() {
  const project = { files: [{ name: 'main.py', text: '' }], scene: defaultScene(), course: null };
  const work = new WorkModel({ project, open: 'main.py', previous: [] }, () => 0);
  const phase = shallowRef<RunPhase>('ready');
  const runStart = shallowRef<Scene | null>(null);
  const told: InputAction[] = [];
  const isActive = computed(() => ['starting', 'running', 'paused', 'stopping'].includes(phase.value));
  effectScope().run(() => useLiveEdits({ phase, isActive, input: (action) => told.push(action) }, work, runStart));
  const start = (): void => {
    phase.value = 'starting';
    runStart.value = work.scene.value;
  };
  /** The course as the run knows it by now. */
  const known = (): Scene =>
    told.reduce((scene, action) => (action.type === 'edit' ? applyEdit(scene, action.edit) : scene), runStart.value!);
  return { work, phase, told, start, known, runStart };
}

describe('a run beside the editor', () => {
  it('hears nothing of edits before it', () => {
    const { work, told } = beside();
    work.edit(adding('a'));
    expect(told).toEqual([]);
  });

  it('hears of each edit, of undo and of redo', () => {
    const { work, phase, told, start, known } = beside();
    start();
    phase.value = 'running';
    work.edit(adding('a'));
    expect(told).toEqual([{ type: 'edit', edit: adding('a') }]);
    work.undo();
    expect(known()).toEqual(work.scene.value);
    work.redo();
    expect(known()).toEqual(work.scene.value);
    expect(told).toHaveLength(3);
  });

  it('hears of what was changed while it started as soon as it listens', () => {
    const { work, phase, told, start, known } = beside();
    start();
    work.edit(adding('a'));
    work.edit(adding('b'));
    expect(told).toEqual([]);
    phase.value = 'running';
    expect(told).toHaveLength(1);
    expect(known()).toEqual(work.scene.value);
  });

  it('hears nothing twice when it is started anew', () => {
    const { work, phase, told, start } = beside();
    start();
    phase.value = 'running';
    work.edit(adding('a'));
    start();
    phase.value = 'running';
    expect(told).toHaveLength(1);
  });

  it('hears nothing any more when it is over', () => {
    const { work, phase, told, start, runStart } = beside();
    start();
    phase.value = 'running';
    phase.value = 'stopped';
    work.edit(adding('a'));
    expect(told).toEqual([]);
    phase.value = 'ready';
    expect(runStart.value).toBeNull();
  });
});
