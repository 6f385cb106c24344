import { describe, expect, it } from 'vitest';
import { computed, effectScope, shallowRef } from 'vue';

import { applyEdit, type SceneEdit } from '#scene/edit';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';
import type { InputAction } from '#simulation/input';
import type { Snapshot } from '#simulation/snapshot';

import type { RunPhase } from '#simulation/pace';

import { createHand } from '../../run/hand';
import { useLiveEdits } from './use-live-edits';
import { WorkModel } from './work-model';

const block = (id: string): SceneObject => ({ type: 'block', id, at: [100, 100], size: [50, 50], angle: 0 });
const adding = (id: string): SceneEdit => ({ type: 'add', objects: [block(id)] });

/** A course that is worked on beside a run that only notes what it is told. */
function beside() {
  const project = { files: [{ name: 'main.py', text: '' }], scene: defaultScene(), course: null };
  const work = new WorkModel({ project, open: 'main.py', previous: [] }, () => 0);
  const phase = shallowRef<RunPhase>('ready');
  const runStart = shallowRef<Scene | null>(null);
  const told: InputAction[] = [];
  const isActive = computed(() => ['starting', 'running', 'paused', 'stopping'].includes(phase.value));
  const snapshot = shallowRef<Snapshot | null>(null);
  const run = {
    ...{ phase, isActive, present: snapshot, input: (action: InputAction) => told.push(action) > 0 },
    reset: () => Promise.resolve(void (snapshot.value = null)),
  };
  const hand = createHand();
  effectScope().run(() => useLiveEdits(run, work, hand, runStart));
  const start = (): void => {
    phase.value = 'starting';
    runStart.value = work.scene.value;
  };
  /** The course as the run knows it by now. */
  const known = (): Scene =>
    told.reduce((scene, action) => (action.type === 'edit' ? applyEdit(scene, action.edit) : scene), runStart.value!);
  return { work, phase, snapshot, told, start, known, runStart, hand };
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
    expect(told[1]).toEqual({ type: 'edit', edit: { type: 'clear' } });
    expect(known()).toEqual(work.scene.value);
    work.redo();
    expect(known()).toEqual(work.scene.value);
    expect(told).toEqual([told[0], told[1], told[0]]);
  });

  it('hears of what is changed while it starts: it takes that at its first moment', () => {
    const { work, phase, told, start, known } = beside();
    start();
    work.edit(adding('a'));
    work.edit(adding('b'));
    phase.value = 'running';
    expect(told).toHaveLength(2);
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

  it('is put back to the start when it is over and its last picture would hide what was changed', () => {
    const { work, phase, snapshot } = beside();
    phase.value = 'stopped';
    snapshot.value = {} as Snapshot;
    work.edit({ type: 'course', changes: { name: 'New' } });
    expect(snapshot.value).not.toBeNull();
    work.edit(adding('a'));
    expect(snapshot.value).toBeNull();
  });

  it('has from the hand what the course has not changed since', () => {
    const { work, hand } = beside();
    work.edit({ type: 'add', objects: [block('a'), block('b')] });
    const pose = { xMm: 10, yMm: 20, headingDeg: 0 };
    hand.pose.value = pose;
    hand.blocks.value = { a: pose, b: pose };
    work.edit({ type: 'remove', ids: ['a'] });
    expect([hand.pose.value, hand.blocks.value]).toEqual([pose, { b: pose }]);
    work.edit({ type: 'robot', robot: { heading: 90 } });
    work.undo();
    work.undo();
    expect([hand.pose.value, hand.blocks.value]).toEqual([null, { b: pose }]);
  });
});
